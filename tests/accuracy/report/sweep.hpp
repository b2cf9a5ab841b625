#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tests/accuracy/experiments.hpp"
#include "tests/accuracy/report/row.hpp"

namespace plumb::accuracy {

struct SweepOptions {
    std::string scene;                        ///< empty: all
    bool quick = false;                       ///< only fast scenes, three qualities, one run of each
    int runs = 3;                             ///< of each, the fastest of which counts
    std::vector<physics::Quality> qualities;  ///< empty: 1 to 64 substeps and automatic
    std::span<const scenes::Engine> peers;    ///< empty: none
    Trial::CountAllocations count = nullptr;
};

/// The methods with which a scene is simulated: the default solver at each quality; without
/// joint trees if it has joints; with each integrator if there are only smooth forces; with
/// more iterations at some qualities; with automatic quality; and with the other engines.
std::vector<Method> methodsOf(const Experiment& experiment, const SweepOptions& options);

/// The scenes selected by these options.
std::vector<const Experiment*> chosen(const SweepOptions& options);

/// The current run, and the total progress.
struct Progress {
    const Experiment* experiment = nullptr;
    std::string method;      ///< in words
    std::size_t number = 0;  ///< number of the run, from 1
    std::size_t all = 0;
    double part = 0.0;  ///< estimated fraction of the work that is done, 0..1
};

/// Runs one experiment with one method: a row for each figure; none if an engine lacks a feature.
std::vector<Row> runOne(const Experiment& experiment, const Method& method, const SweepOptions& options);

/// Runs all.
/// @param progress  called before each
/// @param done      called with the rows of each scene once it is done
std::vector<Row> sweep(const SweepOptions& options, const std::function<void(const Progress&)>& progress,
                       const std::function<void(std::span<const Row>)>& done);

}  // namespace plumb::accuracy
