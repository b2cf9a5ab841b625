#include <array>

#include "tests/accuracy/report/scene_texts.hpp"

// Texts of the hard cases, with and without an exact result. All numbers were measured with ./plumb accuracy.

namespace plumb::accuracy {

namespace {

constexpr auto kHard = std::to_array<SceneText>({
    {.name = "rocking",
     .title = "Plank that rocks on a cylinder",
     .answer = "It rocks on for ever, as high as at the start.",
     .shows = "How much of its swing it loses in 10 s: a quarter at the default, a tenth at 16 substeps, "
              "where others lose a twentieth. It never gains.",
     .choose = "Quality 4 if bodies should rock for long."},
    {.name = "ballandchain",
     .title = "Chain of 40 that swings a ball of 500 links",
     .answer = "The links stay together; the mean gap of their hinges in the second half of 20 "
               "s.",
     .shows = "Swinging is harder than hanging, because every link rotates. With joint trees the gaps are "
              "hundredths of a millimeter at the default; with one substep 26 mm.",
     .choose = "Direct joints and quality 1 or more.",
     .order = 2.0,
     .why = "With one substep the chain is torn, and its motion is different altogether. From two on errors "
            "fall much faster than by second order, until rounding."},
    {.name = "bridge160",
     .title = "Hanging bridge of 160 planks",
     .answer = "The planks stay together; the mean gap of their hinges.",
     .shows = "Both ends are fixed, and the bridge is still solved as a tree: micrometers, where iteratively "
              "solved joints have centimeters.",
     .choose = "Leave direct joints on; any quality.",
     .order = 2.0,
     .why = "It is straight at first and sags only by the gaps of its hinges: the smaller they are, the "
            "larger the tension. The sag s is proportional to the root of the gaps g, the tension to 1/s, "
            "and g to h2 times the tension: so g is proportional to h^(4/3), as measured."},
    {.name = "jointgrid100",
     .title = "Net of 100 x 100 discs",
     .answer = "Held at seven places, it swings; the mean gap of 19,800 hinges.",
     .shows = "A net has loops, so it is not solved as a tree and only substeps help: gaps of 13 mm on "
              "average at the default, a quarter of a millimeter at 32.",
     .choose = "Quality 4 or 5, or fewer joints.",
     .order = 2.0,
     .why = "With one and two substeps the net is torn open by meters; from 4 on each doubling leaves a "
            "quarter."},
    {.name = "heavyontwo",
     .title = "400 to 1: a box that falls on two",
     .answer = "The largest overlap at the impact and at the end.",
     .shows = "The impact itself compresses the small ones by decimeters; at the end they carry it with the "
              "compliance of their contacts.",
     .choose = "Automatic quality.",
     .order = 2.0,
     .why = "It is the maximum overlap during an impact, not one at rest: stiffer springs also push back "
            "later."},
    {.name = "heavyonten",
     .title = "100 kg on a stack of ten",
     .answer = "It stands for 10 s; the largest overlap at the end.",
     .shows = "It falls with one and two substeps and stands at the default, pressed in by 37 "
              "mm. Each further doubling leaves a quarter.",
     .choose = "Automatic quality, or quality 4.",
     .order = 2.0,
     .why = "With one and two substeps it falls, and bodies that lie on the floor hardly overlap: these two "
            "points belong to a different motion."},
    {.name = "heavytops",
     .title = "Pyramids with heavy tops",
     .answer = "Tops of 100, 200 and 300 times a crate's mass; the deepest overlap at the end.",
     .shows = "They stand from two substeps on and sink in by 23 mm at the default; each "
              "doubling leaves a quarter.",
     .choose = "Quality 3, or automatic.",
     .order = 2.0},
    {.name = "stack15",
     .title = "Stack of 15",
     .answer = "It stands for 15 s; how far it leans.",
     .shows = "It stands at the default and does not lean. With one substep it leans by 9 cm.",
     .choose = "The default."},
    {.name = "stack50",
     .title = "Stack of 50",
     .answer = "It stands for 15 s; how far it leans.",
     .shows = "It stands at the default: contacts keep their points, so a column of springs "
              "does not buckle. With one substep it falls.",
     .choose = "The default; quality 3 above 50."},
    {.name = "stack100",
     .title = "Stack of 100",
     .answer = "It stands for 15 s; how far it leans.",
     .shows = "It stands for 15 s at the default, though its lowest crate carries 99 others. "
              "With one substep it falls.",
     .choose = "The default; quality 3 above 50."},
    {.name = "arch",
     .title = "Arch of 17 stones with four crates on it",
     .answer = "The largest move of any of them in 10 s.",
     .shows = "An arch in the shape of a hanging chain stands at the default and settles by 31 "
              "mm; each doubling leaves a quarter.",
     .choose = "Quality 3.",
     .order = 2.0},
    {.name = "farpyramid",
     .title = "Pyramid 100 km away",
     .answer = "As at the origin: the largest overlap at the end.",
     .shows =
         "Positions are stored in double precision and everything else is relative, so distance does not "
         "matter.",
     .choose = "The default, anywhere within 1000 km.",
     .order = 2.0},
    {.name = "pile500",
     .title = "Pile of 500",
     .answer = "The deepest overlap after 20 s, and whether it rests.",
     .shows = "Half a thousand boxes and circles in a shaft. The deepest overlap falls with "
              "every doubling, from 41 cm at one substep to a fifth of a millimetre at 64.",
     .choose = "The default; quality 3 if overlaps show.",
     .order = 2.0},
    {.name = "cramped",
     .title = "625 circles in a box that is too small",
     .answer = "They cannot all fit; the deepest overlap.",
     .shows = "There is no exact answer, only a fair one: all overlap alike. With more substeps the largest "
              "overlap even grows, from 26 to 37 cm.",
     .choose = "Anything; make the box larger.",
     .why = "The circles do not fit: their overlap is determined by the box, not by the method."},
    {.name = "pyramid465",
     .title = "Pyramid of base 30",
     .answer = "465 crates; the largest move of any in 10 s.",
     .shows = "It sinks into itself by 72 mm at the default and by a quarter of that with each "
              "doubling.",
     .choose = "Quality 3.",
     .order = 2.0},
    {.name = "cardhouse",
     .title = "House of cards, five storeys",
     .answer = "Cards of 1 mm; the largest move of any in 10 s.",
     .shows = "It stands at the default and falls with one and two substeps.",
     .choose = "The default, or quality 3 if it must not settle.",
     .why = "It falls with one and two substeps and only settles with more: two different motions in one "
            "fit."},
    {.name = "recovery",
     .title = "Crates placed inside each other",
     .answer = "Ten crates that overlap by a quarter; their separation speed.",
     .shows = "They separate gently, at 0.4 m/s; at 64 substeps the stiffest contacts push the last ones to "
              "0.6 m/s.",
     .choose = "The default.",
     .why = "Their separation speed is determined by pushSpeed and the recovery of initial overlaps, so "
            "substeps do not reduce it."},
    {.name = "ragdolls",
     .title = "Pile of 20 ragdolls",
     .answer = "The largest gap of any joint after 15 s.",
     .shows =
         "Limits, springs and contacts at once, so the joints are solved by the SIMD solver: the worst "
         "of 200 is open by 1 to 60 mm from the default on, depending on how the pile falls. It rests at "
         "every quality.",
     .choose = "The default from afar, quality 5 for close-ups.",
     .why = "Each quality gives a different pile, so the largest gap of 200 joints is partly chance."},
    {.name = "far",
     .title = "The same scene 1 to 1000 km away",
     .answer = "The distance of bodies from where they end up at the origin.",
     .shows = "Up to 100 km the motion is the same to micrometers, at 1000 km nearly always: positions are "
              "double, and everything else is relative. The only exception is 3.5 mm at 1000 km with 64 "
              "substeps.",
     .choose = "Anything; there is no need to move the origin.",
     .why = "The difference is the rounding of double precision at that distance; it is chance whether it "
            "ever changes a bit of single precision."},
    {.name = "pit1000",
     .title = "Pit of 1000 bodies",
     .answer = "The deepest overlap after 20 s.",
     .shows = "Twice the pile's bodies in a wide pit. The overlap falls with substeps, while the time grows "
              "less than their number, because the cost of finding contacts stays the same.",
     .choose = "The default; quality 3 if overlaps show.",
     .order = 2.0},
});

}  // namespace

std::span<const SceneText> hardTexts() { return kHard; }

}  // namespace plumb::accuracy
