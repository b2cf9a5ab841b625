#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tests/accuracy/experiments.hpp"
#include "tests/accuracy/report/row.hpp"

namespace plumb::accuracy {

struct SweepOptions {
    std::string scene;                        ///< name of a scene; empty: all scenes
    bool quick = false;                       ///< true: only fast scenes, three qualities, one run of each
    int runs = 3;                             ///< number of runs of each method; the fastest counts
    std::vector<physics::Quality> qualities;  ///< qualities to run; empty: all, and automatic
    std::span<const scenes::Engine> peers;    ///< other engines to run
    Trial::CountAllocations count = nullptr;  ///< see Trial::Trial()
};

/// Returns the methods with which a scene is simulated: the default solver at each quality; if the scene has
/// joints, also without the direct joint solver; if it has smooth forces only, with each integrator; and with
/// more iterations at some qualities, with automatic quality; and the other engines.
std::vector<Method> methodsOf(const Experiment& experiment, const SweepOptions& options);

/// Returns the scenes selected by the options.
std::vector<const Experiment*> chosen(const SweepOptions& options);

/// Current run and total progress.
struct Progress {
    const Experiment* experiment = nullptr;
    std::string method;      ///< description of the method
    std::size_t number = 0;  ///< number of the current run, from 1
    std::size_t all = 0;     ///< number of runs
    double part = 0.0;       ///< estimated fraction of the work that is done, 0..1
};

/// Runs an experiment with a method. @return a row per figure; empty if an engine lacks a feature
std::vector<Row> runOne(const Experiment& experiment, const Method& method, const SweepOptions& options);

/// Runs all selected scenes with all of their methods.
/// @param progress  called before each run
/// @param done      called with the rows of each finished scene
std::vector<Row> sweep(const SweepOptions& options, const std::function<void(const Progress&)>& progress,
                       const std::function<void(std::span<const Row>)>& done);

}  // namespace plumb::accuracy
