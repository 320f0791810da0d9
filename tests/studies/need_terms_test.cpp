// What the study of need puts in the place of what a scene has is a scene too, and is what its name says.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "benchmarks/studies/need.h"
#include "scene/hash.h"
#include "scene/read.h"
#include "scene/stem.h"
#include "scene/strip.h"

namespace furrow::benchmarks {
namespace {

const Subject& subject(const std::string& name) {
  static const std::vector<Subject> all = subjects(false);
  return *std::find_if(all.begin(), all.end(), [&](const Subject& s) { return s.name == name; });
}

const Term& term(const Subject& of, const std::string& words) {
  static std::vector<Term> all;
  all = terms_of(of);
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Term& t) { return t.name.find(words) != std::string::npos; });
  if (found == all.end()) throw std::out_of_range(of.name + " has no row for " + words);
  return *found;
}

Scene without(const Subject& of, const std::string& words) {
  Scene scene = of.scene();
  term(of, words).drop(scene);
  return scene;
}

TEST(NeedTerms, LeaveAnotherSceneThatCanBeRun) {
  for (const Subject& of : subjects(false)) {
    for (const Term& t : terms_of(of)) {
      Scene scene = of.scene();
      t.drop(scene);
      for (const Problem& p : problems_of(scene)) ADD_FAILURE() << of.name << ", " << t.name << ": " << p.message;
      EXPECT_NE(scene_hash(scene), scene_hash(of.scene())) << of.name << ", " << t.name;
    }
  }
}

TEST(NeedTerms, HaveARowForEachOptionOfTheModel) {
  const Subject& coupled = subject("scenario_3");
  for (const char* option : {"tight plates", "new faces", "tangential force", "after slip", "linear spring", "Thornton",
                             "whole radius", "half the overlap", "dashpot", "rolling spring", "full speed", "driven",
                             "rollers", "a stem", "one strength", "a notch", "list of the contacts"})
    EXPECT_NO_THROW(term(coupled, option)) << option;
}

TEST(NeedTerms, PutAStemThatBendsAndWeighsAsTheLatticeDoes) {
  const Subject& of = subject("scenario_1");
  const Scene scene = without(of, "a stem");
  ASSERT_TRUE(scene.lattice[0].stem.has_value());
  std::vector<Lattice> stem = scene.lattice;
  fill_stems(stem, scene.material);
  const Beam was = *beam_of(of.scene().lattice[0]), is = *beam_of(stem[0]);
  EXPECT_EQ(stem[0].rows, of.scene().lattice[0].rows);
  EXPECT_NEAR(is.bending / was.bending, 1, 1e-12) << "rounding of a closed form";
  EXPECT_NEAR(is.mass / was.mass, 1, 1e-12) << "rounding of a closed form";
}

// 2 sqrt(5/6) beta sqrt(Sn m*), where two discs of 0.314 kg overlap by 1 mm: R* = 5 mm, E* = 1e5/(1 - nu^2), nu = -1/2.
TEST(NeedTerms, PutADashpotThatDampsLikeTheFactorWhereDiscsOverlapByATenth) {
  const double stiffness = 2 * 1e5 / 0.75 * std::sqrt(0.005 * 0.001);
  const double want = 2 * std::sqrt(5.0 / 6.0) * 20 * std::sqrt(stiffness * 1000 * 3.14159265358979 * 1e-4 / 2);
  const Scene scene = without(subject("scenario_2"), "dashpot");
  EXPECT_FALSE(scene.contact.damping_factor.has_value());
  EXPECT_NEAR(scene.contact.damping.value_or(0) / want, 1, 1e-9) << "digits of pi";
}

}  // namespace
}  // namespace furrow::benchmarks
