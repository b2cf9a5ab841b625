#include <array>

#include "tests/accuracy/report/scene_texts.hpp"

// Of the hard cases, with and without an answer. What is said of figures is what ./plumb accuracy found.

namespace plumb::accuracy {

namespace {

constexpr auto kHard = std::to_array<SceneText>({
    {.name = "rocking",
     .title = "Plank that rocks on a cylinder",
     .answer = "It rocks on for ever, as high as it began.",
     .shows = "How much of its swing it loses in 10 s: a quarter at the default, a tenth at 16 substeps, "
              "where others lose a twentieth. It never gains.",
     .choose = "Quality 4 where things should rock for long."},
    {.name = "ballandchain",
     .title = "Chain of 40 that swings a ball of 500 links",
     .answer = "The links stay together; the mean gap of their hinges in the second half of 20 "
               "s.",
     .shows = "Swinging is harder than hanging, as every link turns. The trees hold it to "
              "hundredths of a millimetre at the default; at one substep it opens by 26 mm.",
     .choose = "Direct joints and quality 1 or more.",
     .order = 2.0,
     .why = "With one substep the chain is torn to another swing altogether. From there "
            "errors fall much faster than by the second order, until rounding."},
    {.name = "bridge160",
     .title = "Hanging bridge of 160 planks",
     .answer = "The planks stay together; the mean gap of their hinges.",
     .shows = "Both ends are held and the whole is still solved as a tree: micrometres where "
              "one by one it is centimetres.",
     .choose = "Leave direct joints on; any quality.",
     .order = 2.0,
     .why = "It is straight at first and sags only by what its hinges give: the less they give, "
            "the harder it is pulled. The sag s goes with the root of the gaps g, the pull with "
            "1/s, and g with h2 times the pull: so g goes with h to the power of 4/3, as "
            "measured."},
    {.name = "jointgrid100",
     .title = "Net of 100 x 100 discs",
     .answer = "Held at seven places, it swings; the mean gap of 19,800 hinges.",
     .shows = "A net has loops, so no tree can solve it and substeps are all there is: gaps of "
              "13 mm on average at the default, a quarter of a millimetre at 32.",
     .choose = "Quality 4 or 5, or fewer joints.",
     .order = 2.0,
     .why = "With one and two substeps the net is torn open by metres; from 4 on each "
            "doubling leaves a quarter."},
    {.name = "heavyontwo",
     .title = "400 to 1: a box that falls on two",
     .answer = "The deepest overlap at the blow and at the end.",
     .shows = "The blow itself presses the small ones in by decimetres; at the end they carry "
              "it with what their springs give.",
     .choose = "Automatic quality.",
     .order = 2.0,
     .why = "It is the overlap at the worst moment of a blow, not one at rest: stiffer "
            "springs also push back later."},
    {.name = "heavyonten",
     .title = "100 kg on a stack of ten",
     .answer = "It stands for 10 s; the deepest overlap at the end.",
     .shows = "It falls with one and two substeps and stands at the default, pressed in by 37 "
              "mm. Each further doubling leaves a quarter.",
     .choose = "Automatic quality, or quality 4.",
     .order = 2.0,
     .why = "With one and two substeps it falls, and what lies on the floor hardly overlaps: "
            "these two points are of another motion."},
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
     .answer = "As at home: the deepest overlap at the end.",
     .shows = "Places are kept in double precision and everything else from body to body, so "
              "distance costs nothing.",
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
     .shows = "There is no right answer but a fair one: all share the lack of room. With more "
              "substeps the deepest overlap even grows, from 26 to 37 cm.",
     .choose = "Anything; make the box larger.",
     .why = "The circles have no room: how much they overlap is given by the box, not by the "
            "method."},
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
     .why = "It falls with one and two substeps and only settles with more: two motions on "
            "one line."},
    {.name = "recovery",
     .title = "Crates put into each other",
     .answer = "Ten crates that overlap by a quarter; how fast they part.",
     .shows = "They part calmly, at 0.4 m/s; at 64 substeps the stiffest contacts push the last "
              "ones to 0.6 m/s.",
     .choose = "The default.",
     .why = "How fast they part is set by pushSpeed and the easing of overlaps, so substeps "
            "do not make it smaller."},
    {.name = "ragdolls",
     .title = "Pile of 20 ragdolls",
     .answer = "The largest gap of any joint after 15 s.",
     .shows = "Limits, springs and contacts at once, so the joints are left to the lanes: the "
              "worst of 200 is open by 1 to 60 mm from the default on, as the pile happens "
              "to fall. It rests at every quality.",
     .choose = "The default from afar, quality 5 for close-ups.",
     .why = "Each quality makes another pile, so the largest gap of 200 joints is partly "
            "chance."},
    {.name = "far",
     .title = "The same scene 1 to 1000 km away",
     .answer = "How far bodies end up from where those at home do.",
     .shows = "Up to 100 km the same scene moves alike to micrometres, at 1000 km nearly "
              "always: places are double, and what is compared is always near. The one "
              "exception is 3.5 mm at 1000 km with 64 substeps.",
     .choose = "Anything; there is no need to move the origin.",
     .why = "The difference is the rounding of double precision at that distance, and chance "
            "whether it ever changes a bit of single precision."},
    {.name = "pit1000",
     .title = "Pit of 1000 bodies",
     .answer = "The deepest overlap after 20 s.",
     .shows = "Twice the pile in a wide pit. The deepest overlap falls with substeps while the "
              "time grows less than they do, as finding contacts costs the same.",
     .choose = "The default; quality 3 if overlaps show.",
     .order = 2.0},
});

}  // namespace

std::span<const SceneText> hardTexts() { return kHard; }

}  // namespace plumb::accuracy
