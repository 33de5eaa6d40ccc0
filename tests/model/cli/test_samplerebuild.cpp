// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/model/cli/clifixture.h"

#include <cstdlib>
#include <limits>

using namespace quadrille;
using namespace quadrille::test;
namespace fs = std::filesystem;
using ::testing::HasSubstr;

namespace {

/// A deviation in a report of a walk, as `quadrille data` writes it; infinite where there is none.
double deviation(const std::string& report, const std::string& which)
{
    const std::string row = "\n" + which + " deviation,,0,";
    const auto at = report.find(row);
    return at == std::string::npos ? std::numeric_limits<double>::infinity()
                                   : std::stod(report.substr(at + row.size()));
}

class SampleRebuild : public Cli
{
protected:
    /// By the program itself.
    Outcome run(const std::vector<std::string>& arguments) const
    {
        return runQuadrille(arguments, folder.path());
    }
};

} // namespace

// One test, because it takes long to compute the sample as it comes. Where QUADRILLE_REBUILT_SAMPLE names a
// folder it is left there for other tests (see CMakeLists.txt).
TEST_F(SampleRebuild, makesExportsAndASheetAndItsTourStaysWithinTenCentimetresOfItsPath)
{
    const char* kept = std::getenv("QUADRILLE_REBUILT_SAMPLE");
    const fs::path demo = kept != nullptr ? fs::path(kept) : folder / "demo";
    fs::remove_all(demo);
    const std::string project = (demo / "sample.quadrille").string();
    const Outcome sample = run({"sample", demo.string()});
    ASSERT_EQ(sample.status, 0) << sample.err;
    EXPECT_THAT(sample.out, HasSubstr(project));
    EXPECT_EQ(run({"check", project}).status, 0);
    const Outcome rebuilt = run({"rebuild", project, "--json", "report.json"});
    ASSERT_EQ(rebuilt.status, 0) << rebuilt.err;
    EXPECT_EQ(Json::parse(textOf(folder / "report.json"))["failed"], 0);
    EXPECT_THAT(rebuilt.out, HasSubstr("contact-sheet.png"));

    const Outcome tour = run({"data", project, "animations/along an S/report"});
    EXPECT_LE(deviation(tour.out, "greatest"), 0.1);
    EXPECT_LE(deviation(tour.out, "mean"), 0.05); // within its dead zone
}
