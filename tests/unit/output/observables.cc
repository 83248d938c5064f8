// Names of observables and of their columns.

#include <thelma/base/error.h>
#include <thelma/output/observables/chosen_observables.h>

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace thelma;
using Names = std::vector<std::string>;

Names columns(const std::string& text)
{
  const ParameterFile file = ParameterFile::from_text(text);
  ChosenObservables<3> observables(file);
  dealii::ParameterHandler prm;
  {
    const Section section(prm, {"Output"});
    observables.declare_names(prm);
  }
  observables.declare(prm);
  file.read(prm);
  return observables.columns();
}

/// A file with these observables, all of free names, as `name: kind`.
std::string scene(const std::vector<std::pair<std::string, std::string>>& observables)
{
  std::string listed, sections;
  for (const auto& [name, kind] : observables) {
    listed += (listed.empty() ? "" : ", ") + name;
    sections += "subsection " + name + "\n set Kind = " + kind + "\nend\n";
  }
  return "subsection Output\n set Observables = " + listed + "\nend\nsubsection Observables\n" +
         sections + "end\n";
}

TEST(ObservableNames, TheNameOfItsKindLeavesTheColumns)
{
  for (const std::string column : {"probe_phi_kV", "probe", "probes", "max_det_F"})
    EXPECT_EQ((ObservableName{"probe", "probe"}.column(column)), column);
  EXPECT_EQ(columns("subsection Output\n set Observables = tip, charge, mid_rotation\nend\n"),
            (Names{"tip_u1_mm", "tip_u2_mm", "tip_u3_mm", "charge_uC", "capacitance_nF",
                   "mid_rotation_deg"}));
}

TEST(ObservableNames, AFreeNameBeginsTheColumns)
{
  EXPECT_EQ((ObservableName{"probe", "left"}.column("probe_phi_kV")), "left_phi_kV");
  EXPECT_EQ((ObservableName{"lambda_3", "left"}.column("lambda_3")), "left");
  EXPECT_EQ((ObservableName{"probe", "left"}.column("probes_kV")), "left_probes_kV");
  EXPECT_EQ(
      columns(scene(
          {{"left", "charge"}, {"corner", "tip"}, {"knee", "rotation"}, {"wall", "reaction"}})),
      (Names{"left_uC", "left_capacitance_nF", "corner_u1_mm", "corner_u2_mm", "corner_u3_mm",
             "knee_deg", "wall_f1_N", "wall_f2_N", "wall_f3_N"}));
}

TEST(ObservableNames, TheKindOfAKnownNameMayBeRepeated)
{
  EXPECT_EQ(columns(scene({{"charge", "charge"}})), (Names{"charge_uC", "capacitance_nF"}));
}

TEST(ObservableNames, NamesWithoutAKindAreAnswered)
{
  const auto answer = [](const std::string& text) {
    try {
      columns(text);
    } catch (const InputError& error) {
      return error.sentences();
    }
    return Names();
  };
  const auto expect_one = [&](const std::string& text, const Names& words) {
    const Names sentences = answer(text);
    ASSERT_EQ(sentences.size(), 1u);
    for (const std::string& word : words)
      EXPECT_NE(sentences.front().find(word), std::string::npos) << sentences.front() << word;
  };
  expect_one("subsection Output\n set Observables = left\nend\nsubsection Observables\n"
             " subsection left\n  set At = top\n end\nend\n",
             {":2,", "'left'", "no Kind", "known: charge"});
  expect_one("subsection Output\n set Observables = left_prob\nend\nsubsection Observables\n"
             " subsection left_probe\n  set Kind = probe\n end\nend\n",
             {":2,", "did you mean 'left_probe'?"});
  expect_one(scene({{"left", "prob"}}),
             {":6,", "'prob'", "did you mean 'probe'?", "Known: charge"});
  expect_one(scene({{"probe", "charge"}}), {":6,", "'charge'", "choose another name"});
  expect_one(scene({{"le ft", "probe"}}), {":2,", "'le ft'", "letters, digits and _"});
}

} // namespace
