#include "editor/model/document/expression.hpp"

#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "core/text.hpp"

namespace plumb::editor {
namespace {

double valueOf(std::string_view text) {
    const Result<double> value = evaluate(text);
    EXPECT_TRUE(value.ok()) << text << ": " << (value ? "" : value.error().text());
    return value ? *value : -12345.0;
}

std::string problemOf(std::string_view text) {
    const Result<double> value = evaluate(text);
    EXPECT_FALSE(value.ok()) << text;
    return value ? std::string{} : value.error().text();
}

TEST(Expressions, followTheRulesOfArithmetic) {
    EXPECT_EQ(valueOf("16*3+4"), 52.0);
    EXPECT_EQ(valueOf(" 4 + 16 * 3 "), 52.0);
    EXPECT_EQ(valueOf("(4+16)*3"), 60.0);
    EXPECT_EQ(valueOf("10-4-3"), 3.0) << "from left to right";
    EXPECT_EQ(valueOf("64/4/2"), 8.0);
    EXPECT_EQ(valueOf("2^3^2"), 512.0) << "powers from right to left";
    EXPECT_EQ(valueOf("-2^2"), -4.0);
    EXPECT_EQ(valueOf("2^-1"), 0.5);
    EXPECT_EQ(valueOf("7%4"), 3.0);
    EXPECT_EQ(valueOf("--3"), 3.0);
    EXPECT_EQ(valueOf(".5"), 0.5);
    EXPECT_EQ(valueOf("1e3"), 1000.0);
}

TEST(Expressions, knowFunctionsAndConstants) {
    EXPECT_EQ(valueOf("sqrt(16)"), 4.0);
    EXPECT_EQ(valueOf("max(3, 4) + min(1, 2)"), 5.0);
    EXPECT_EQ(valueOf("clamp(300, 0, 255)"), 255.0);
    EXPECT_EQ(valueOf("round(2.6) + floor(2.6) + ceil(2.1) + abs(-1)"), 9.0);
    EXPECT_NEAR(valueOf("deg(pi)"), 180.0, 1e-12);
    EXPECT_NEAR(valueOf("sin(rad(30))"), 0.5, 1e-12);
    EXPECT_NEAR(valueOf("deg(atan2(1, 1))"), 45.0, 1e-12);
    EXPECT_NEAR(valueOf("tau / pi"), 2.0, 1e-15);
}

TEST(Expressions, reportErrorsWithTheirColumn) {
    EXPECT_EQ(problemOf("16*"), "column 4: expected a number, found the end");
    EXPECT_EQ(problemOf("3+*4"), "column 3: expected a number, found \"*\"");
    EXPECT_EQ(problemOf("(1+2"), "column 5: expected ) for the ( in column 1, found the end");
    EXPECT_EQ(problemOf("1)"), "column 2: expected an operator, found \")\"");
    EXPECT_EQ(problemOf("12px"), "column 3: unexpected \"p\" after the number \"12\"");
    EXPECT_EQ(problemOf("1,5"), "column 2: expected an operator, found \",\"");
    EXPECT_EQ(problemOf("4/0"), "column 2: division by 0");
    EXPECT_EQ(problemOf("4%(2-2)"), "column 2: division by 0");
    EXPECT_EQ(problemOf("1+sqrt(-4)"), "column 3: the result of sqrt is not a finite number");
    EXPECT_EQ(problemOf("max(1)"), "column 6: max needs 2 numbers; expected a comma, found \")\"");
    EXPECT_EQ(problemOf("1e999"), "column 1: the number is too large or too small");
    EXPECT_EQ(problemOf("9^9^9"), "column 2: the power is not a finite number");
    EXPECT_EQ(problemOf("2\xc3\x97"
                        "3"),
              "column 2: expected an operator, found \"\xc3\x97\"");
    EXPECT_EQ(problemOf(""), "column 1: expected a number, found the end");
    EXPECT_TRUE(startsWith(problemOf("sqr(4)"), "column 1: unknown name \"sqr\"; use pi, tau, sqrt"));
    EXPECT_TRUE(
        startsWith(problemOf(std::string(5000, '(')), "column 65: the expression is nested too deeply"));
}

TEST(Expressions, applyToThePresentValueIfTheyBeginWithASign) {
    const auto over = [](std::string_view text) {
        return *typedNumber(text, {.value = 8.0, .index = 2, .count = 5});
    };
    EXPECT_EQ(over("+=10"), 18.0);
    EXPECT_EQ(over("-=10"), -2.0);
    EXPECT_EQ(over("*=2"), 16.0);
    EXPECT_EQ(over("/=2"), 4.0);
    EXPECT_EQ(over("*2"), 16.0);
    EXPECT_EQ(over(" / (1+1) "), 4.0);
    EXPECT_EQ(over("+10"), 10.0) << "a plain number with its sign";
    EXPECT_EQ(over("-10"), -10.0);
    EXPECT_EQ(over("x^2 + 16*i + n"), 101.0);
    EXPECT_EQ(typedNumber("+=", {}).error().text(), "column 3: expected a number, found the end");
    EXPECT_EQ(typedNumber("/=0", {}).error().text(), "column 2: division by 0");
    EXPECT_FALSE(typedNumber("*1e308", {.value = 1e300}).ok());
}

// ---- reference evaluation: random expression trees, evaluated without parsing

struct Tree {
    char sign = '\0';  // \0 number, + - * /, n negation, s square root of the square of `left`
    double number = 0.0;
    std::unique_ptr<Tree> left;
    std::unique_ptr<Tree> right;
};

std::unique_ptr<Tree> randomTree(Random& random, int depth) {
    auto tree = std::make_unique<Tree>();
    const std::uint32_t kind = depth == 0 ? 0 : random.below(8);
    if (kind < 2) {
        tree->number = static_cast<double>(random.below(1000)) / 8.0;
        return tree;
    }
    tree->sign = "..+-*/ns"[kind];
    tree->left = randomTree(random, depth - 1);
    if (kind < 6) tree->right = randomTree(random, depth - 1);
    return tree;
}

double evaluateTree(const Tree& tree) {
    switch (tree.sign) {
        case '+': return evaluateTree(*tree.left) + evaluateTree(*tree.right);
        case '-': return evaluateTree(*tree.left) - evaluateTree(*tree.right);
        case '*': return evaluateTree(*tree.left) * evaluateTree(*tree.right);
        case '/': {
            const double by = evaluateTree(*tree.right);
            return by == 0.0 ? std::nan("") : evaluateTree(*tree.left) / by;
        }
        case 'n': return -evaluateTree(*tree.left);
        case 's': return std::sqrt(evaluateTree(*tree.left) * evaluateTree(*tree.left));
        default: return tree.number;
    }
}

int precedenceOf(const Tree& tree) {
    return tree.sign == '+' || tree.sign == '-' ? 1 : tree.sign == '\0' || tree.sign == 's' ? 3 : 2;
}

/// Writes a tree as text, with parentheses only where precedence requires them and random spaces.
std::string textOf(const Tree& tree, Random& random) {
    const auto inside = [&](const Tree& part, int least) {
        const std::string text = textOf(part, random);
        return precedenceOf(part) < least ? format("({})", text) : text;
    };
    const std::string space(random.below(2), ' ');
    switch (tree.sign) {
        case '\0': return shortestText(tree.number);
        case 'n': return format("-{}", inside(*tree.left, 3));
        case 's': {
            const std::string part = inside(*tree.left, 3);
            return format("sqrt({}*{})", part, part);
        }
        default: break;
    }
    const int strength = precedenceOf(tree);
    return format("{}{}{}{}{}", inside(*tree.left, strength), space, tree.sign, space,
                  inside(*tree.right, strength + 1));
}

TEST(Expressions, haveTheValuesOfTheirTrees) {
    Random random = Random::seeded(7);
    int finite = 0;
    for (int i = 0; i < 5000; ++i) {
        const auto tree = randomTree(random, 5);
        const double expected = evaluateTree(*tree);
        const std::string text = textOf(*tree, random);
        const Result<double> value = evaluate(text);
        if (std::isnan(expected)) {
            ASSERT_FALSE(value.ok()) << text << " divides by 0 somewhere";
            continue;
        }
        ASSERT_TRUE(value.ok()) << text << ": " << value.error().text();
        ASSERT_DOUBLE_EQ(*value, expected) << text;
        ++finite;
    }
    EXPECT_GT(finite, 4000);
}

TEST(Expressions, surviveDamagedTexts) {
    Random random = Random::seeded(11);
    constexpr std::string_view kLetters = "0123456789.+-*/%^(),= \tesqrtpix\"#\xc3\xa4\xff";
    int refused = 0;
    for (int i = 0; i < 50000; ++i) {
        std::string text = textOf(*randomTree(random, 4), random);
        for (std::uint32_t hits = 1 + random.below(4); hits > 0; --hits) {
            const auto at = random.below(static_cast<std::uint32_t>(text.size() + 1));
            const char letter = kLetters[random.below(static_cast<std::uint32_t>(kLetters.size()))];
            switch (random.below(3)) {
                case 0: text.insert(at, 1, letter); break;
                case 1: text.erase(at, 1 + random.below(3)); break;
                default: text.replace(at, 1, 1, letter);
            }
        }
        const Result<double> value = typedNumber(text, {.value = 3.0});
        if (value) {
            ASSERT_TRUE(std::isfinite(*value)) << text;
            continue;
        }
        ++refused;
        const std::string problem = value.error().text();
        ASSERT_TRUE(startsWith(problem, "column ")) << text << ": " << problem;
        const std::optional<std::int64_t> column = parseInt(problem.substr(7, problem.find(':') - 7));
        ASSERT_TRUE(column && *column >= 1 && *column <= static_cast<std::int64_t>(text.size()) + 1)
            << text << ": " << problem;
        ASSERT_TRUE(isUtf8(problem) || !isUtf8(text)) << text;
    }
    EXPECT_GT(refused, 10000);
}

}  // namespace
}  // namespace plumb::editor
