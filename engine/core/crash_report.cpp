#include "core/crash_report.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>

namespace plumb {
namespace {

namespace fs = std::filesystem;

using Char = Path::value_type;

constexpr int kTerminal = 2;  // stderr
constexpr std::size_t kLongestPath = 4096;
constexpr std::string_view kName = "/crash-YYYYMMDD-HHMMSS-N.replay.part";
constexpr int kFilesInASecond = 9;

// Filled before a crash, when memory can be allocated no more.
std::atomic<const CrashReport*> current{nullptr};
std::array<Char, kLongestPath> folderText{};
std::size_t folderSize = 0;
std::array<char, 512> reasonText{};
std::size_t reasonSize = 0;
std::array<char, 512> remedyText{};
std::size_t remedySize = 0;

/// The path of a report.
class ReportPath {
public:
    /// @param number  of the report in this second, from 1
    ReportPath(const crash::Date& date, int number) {
        std::copy_n(folderText.begin(), folderSize, final_.begin());
        size_ = folderSize;
        add("/crash-"), add(date.year, 4), add(date.month, 2), add(date.day, 2);
        add("-"), add(date.hour, 2), add(date.minute, 2), add(date.second, 2);
        if (number > 1) add("-"), add(number, 1);
        add(".replay");
        part_ = final_;
        for (const char c : std::string_view{".part"}) part_[size_++] = static_cast<Char>(c);
    }
    [[nodiscard]] const Char* final() const { return final_.data(); }
    [[nodiscard]] const Char* part() const { return part_.data(); }  ///< until the file is complete

private:
    void add(std::string_view text) {
        for (const char c : text) final_[size_++] = static_cast<Char>(c);
    }
    void add(int number, int digits) {
        for (int i = digits - 1; i >= 0; --i, number /= 10)
            final_[size_ + static_cast<std::size_t>(i)] = static_cast<Char>('0' + number % 10);
        size_ += static_cast<std::size_t>(digits);
    }

    std::array<Char, kLongestPath + kName.size() + 1> final_{}, part_{};
    std::size_t size_ = 0;
};

/// Writes the path as UTF-8; characters beyond the first 128 of Windows as '?'.
void print(CrashOutput& out, const Char* path) {
    for (; *path != Char{}; ++path) {
        const char c =
            sizeof(Char) == 1 || static_cast<std::uint32_t>(*path) < 128 ? static_cast<char>(*path) : '?';
        out.text({&c, 1});
    }
}

/// Writes the file under another name first, so that one with the name of a report is complete but for the
/// back trace, which may fail if the stack is damaged.
void writeFile(const CrashReport& report, const Crash& what, CrashOutput& terminal,
               void (*trace)(CrashOutput&, int, bool)) {
    if (folderSize == 0) return;
    const crash::Date date = crash::now();
    for (int number = 1; number <= kFilesInASecond; ++number) {
        const ReportPath path{date, number};
        if (crash::exists(path.final())) continue;
        const int file = crash::createFile(path.part());
        if (file < 0) continue;
        CrashOutput out{file};
        report.writeFile(out, what);
        if (out.failed() || !crash::renameFile(path.part(), path.final())) {
            crash::closeFile(file);
            crash::removeFile(path.part());
            terminal.text("the report could not be written: the disk is full\n");
            return;
        }
        terminal.text("the report is in ");
        print(terminal, path.final());
        terminal.text("\n");
        report.explain(terminal, what);
        trace(out, file, false);
        crash::closeFile(file);
        return;
    }
    terminal.text("the report could not be written: no file can be created in ");
    print(terminal, folderText.data());
    terminal.text("\n");
}

[[noreturn]] void endAtException() {
    if (const std::exception_ptr thrown = std::current_exception()) {
        try {
            std::rethrow_exception(thrown);
        } catch (const std::bad_alloc&) {
            setCrashReason("out of memory");
        } catch (const fs::filesystem_error& error) {  // its text has whole paths
            std::string reason = error.code().message();
            for (const Path& path : {error.path1(), error.path2()})
                if (path.has_filename()) reason += ": " + path.filename().string();
            setCrashReason(reason);
        } catch (const std::exception& exception) {
            setCrashReason(exception.what());
        } catch (...) {
            setCrashReason("an exception that is no std::exception");
        }
    }
    std::abort();
}

}  // namespace

CrashOutput& CrashOutput::text(std::string_view text) {
    while (!text.empty() && !failed_) {
        const std::int64_t written = crash::writeSome(file_, text.data(), text.size());
        failed_ = written <= 0;
        if (!failed_) text.remove_prefix(static_cast<std::size_t>(written));
    }
    return *this;
}

CrashOutput& CrashOutput::number(std::uint64_t number) {
    std::array<char, 20> digits{};
    std::size_t first = digits.size();
    do {
        digits[--first] = static_cast<char>('0' + number % 10);
        number /= 10;
    } while (number > 0);
    return text({digits.data() + first, digits.size() - first});
}

CrashOutput& CrashOutput::hex(std::uint64_t number) {
    std::array<char, 16> digits{};
    for (std::size_t i = digits.size(); i-- > 0; number >>= 4) digits[i] = "0123456789abcdef"[number & 15];
    return text({digits.data(), digits.size()});
}

void setCrashReport(const CrashReport* report, const Path& folder) {
    current.store(nullptr);
    const Path::string_type& text = folder.native();
    folderSize = text.size() < kLongestPath ? text.size() : 0;
    std::copy_n(text.begin(), folderSize, folderText.begin());
    folderText[folderSize] = Char{};
    current.store(report);
}

void setCrashReason(std::string_view reason) {
    reasonSize = std::min(reason.size(), reasonText.size() - 1);
    for (std::size_t i = 0; i < reasonSize; ++i) {
        const char c = reason[i];
        reasonText[i] = static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
}

namespace crash {

void write(const Crash& crash, void (*trace)(CrashOutput& out, int file, bool isTerminal)) {
    CrashOutput terminal{kTerminal};
    terminal.text(crash.isHang ? "\nplumb: the program hangs: " : "\nplumb: the program crashed: ");
    terminal.text(crash.what);
    if (!crash.reason.empty()) terminal.text(": ").text(crash.reason);
    terminal.text("\nrunning: ").text(crash.running.empty() ? "no system or handler" : crash.running);
    terminal.text("\n").text({remedyText.data(), remedySize}).text("\n");
    const CrashReport* report = current.load();
    if (report != nullptr) {
        folderSize > 0 ? writeFile(*report, crash, terminal, trace) : report->explain(terminal, crash);
    }
    trace(terminal, kTerminal, true);  // last, because it may fail if the stack is damaged
}

void reportExceptions() { std::set_terminate(endAtException); }

std::string_view reason() { return {reasonText.data(), reasonSize}; }

bool endsAtHang() {
    const CrashReport* report = current.load();
    return report != nullptr && report->endsAtHang();
}

void setRemedy(std::string_view remedy) {
    remedySize = std::min(remedy.size(), remedyText.size());
    std::copy_n(remedy.begin(), remedySize, remedyText.begin());
}

}  // namespace crash
}  // namespace plumb
