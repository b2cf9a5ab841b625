#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tests/accuracy/experiments.hpp"
#include "tests/accuracy/report/row.hpp"

namespace plumb::accuracy {

struct SweepOptions {
    std::string scene;                        ///< empty for all
    bool quick = false;                       ///< scenes that take a moment, three qualities, one run of each
    int runs = 3;                             ///< of each, of which the fastest counts
    std::vector<physics::Quality> qualities;  ///< empty for 1 to 64 substeps and automatic
    std::span<const scenes::Engine> peers;    ///< empty for none
    Trial::CountAllocations count = nullptr;
};

/// The ways in which a scene is simulated: the default solver at each quality; without joint trees where it
/// has joints; with each integrator where smooth forces alone act; with more iterations at some
/// qualities; at automatic quality; and by the other engines.
std::vector<Method> methodsOf(const Experiment& experiment, const SweepOptions& options);

/// The scenes that these options ask for.
std::vector<const Experiment*> chosen(const SweepOptions& options);

/// What runs now, and how far it all is.
struct Progress {
    const Experiment* experiment = nullptr;
    std::string method;      ///< in words
    std::size_t number = 0;  ///< of it, from 1 on
    std::size_t all = 0;
    double part = 0.0;  ///< of the work that is done, 0..1, as far as it can be guessed
};

/// Does one experiment in one way: a row for each of its figures; none where an engine lacks what it needs.
std::vector<Row> runOne(const Experiment& experiment, const Method& method, const SweepOptions& options);

/// Does all.
/// @param progress  called before each
/// @param done      called with the rows of each scene once it is done
std::vector<Row> sweep(const SweepOptions& options, const std::function<void(const Progress&)>& progress,
                       const std::function<void(std::span<const Row>)>& done);

}  // namespace plumb::accuracy
