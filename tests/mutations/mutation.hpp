#pragma once
// Seeded faults: proof that the gates ring. A shipped study with fewer levels is run as it is and must pass; then one
// part of it is broken, and it must not pass, for a reason that was named beforehand. The product has no switch for
// this: what is broken is put in through `studies::Parts`, or by changing the plan or the list of runs, which are plain
// values.
//
//   broken.hpp      one part of every run in place of the house's
//   drivers.hpp     simulations made of the house's kernels and a broken piece
//   <class>.cpp     the faults of one class, one row each
//   docs/mutations.md lists the rows; a test compares
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "studies/engine/run.hpp"

namespace ordo::tests {

/// A study of the house with fewer levels: {"walker_2012/sod", {"cells=200,400,800"}}. What it expects stays as it is;
/// printed values of levels that are left out are left out.
struct Shipped {
    std::string name;
    std::vector<std::string> levels;
};

/// What is broken; empty members break nothing.
struct Broken {
    std::optional<studies::Parts> parts{};                       ///< what a run is made of
    std::string solver{};                                        ///< only its runs are made of them; empty: all
    std::function<void(std::vector<studies::RunSpec>&)> plan{};  ///< before the runs
    std::function<void(std::vector<studies::Run>&)> runs{};      ///< after them
};

/// One row of the suite.
struct Mutation {
    std::string what;  ///< what is broken, in words
    Shipped study;
    Broken broken;
    std::vector<studies::Fault> caught_by;  ///< each of these names is a right answer
};

/// The rows of one class.
struct MutationClass {
    std::string name;
    std::vector<Mutation> rows;
};

MutationClass broken_solvers();  ///< physics and numbers of a method
MutationClass broken_kernels();  ///< the same from inside: basis, law, mass, time scheme, medium
MutationClass broken_norms();
MutationClass broken_times();
MutationClass broken_oracles();
MutationClass broken_studies();  ///< plan and list of runs
std::vector<MutationClass> all_mutations();

/// A plausible fault that a study as shipped does not see, and why.
struct BlindSpot {
    std::string what;
    Shipped study;
    Broken broken;
    std::string why;
};
std::vector<BlindSpot> blind_spots();

/// The answer to the study as it is. Kept: each study is run once.
const studies::Result& unbroken(const Shipped& study);

/// The answer with the fault in it.
studies::Result broken(const Shipped& study, const Broken& broken);

/// Checks that do not pass, one a line: fault, claim, subject and what was found.
std::string what_rings(const studies::Result& result);

/// Whether one of the checks that do not pass is named by one of these.
bool rings(const studies::Result& result, const std::vector<studies::Fault>& names);

/// Checks every row of the class.
void try_all(const MutationClass& mutations);

}  // namespace ordo::tests
