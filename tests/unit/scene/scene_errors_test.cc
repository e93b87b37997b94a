// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene_files.h"

using SceneErrors = hybrid::scene::test::SceneFiles;

TEST_F(SceneErrors, UnknownSectionIsNamedWithASuggestion)
{
  expect_error(write_scene("subsection Tiem\n  set End time = 1\nend\n"),
               {"scene.prm:20: ", "unknown section 'Tiem'", "did you mean 'Time'?"});
}

TEST_F(SceneErrors, UnknownParameterIsNamedWithASuggestion)
{
  expect_error(
    write_scene("subsection Time\n\n  set Time stp = 1\nend\n"),
    {"scene.prm:21: ", "unknown parameter 'Time/Time stp'", "did you mean 'Time step'?"});
}

TEST_F(SceneErrors, ParameterInTheWrongSectionIsFoundElsewhere)
{
  expect_error(
    write_scene("subsection Time\n  set Threads = 1\nend\n"),
    {"scene.prm:20: ", "unknown parameter 'Time/Threads'", "did you mean 'Parallel/Threads'?"});
}

TEST_F(SceneErrors, MaterialThatIsNotInTheListOfNamesIsRefused)
{
  expect_error(
    write_scene("subsection Materials\n  subsection sand\n    set Density = 1\n  end\nend\n"),
    {"scene.prm:21: ", "unknown section 'Materials/sand'", "Materials/Names does not list 'sand'"});
}

TEST_F(SceneErrors, MaterialWithoutAnyNameIsRefusedInTheSameWords)
{
  expect_error(write_scene(),
               {"unknown section 'Materials/rock'", "Materials/Names does not list 'rock'"},
               {"Materials/Names="});
}

TEST_F(SceneErrors, DuplicateParameterNamesBothPlaces)
{
  expect_error(write_scene("subsection Blocks\n  set Material = rock\nend\n"),
               {"scene.prm:20: ", "'Blocks/Material' is set a second time", "scene.prm:17"});
}

TEST_F(SceneErrors, DuplicateInAnIncludedFileNamesBothFiles)
{
  write("more.prm", "subsection Blocks\n  set Material = rock\nend\n");
  expect_error(write_scene("include more.prm\n"),
               {"more.prm:2: ", "a second time", "scene.prm:17", "include a file before"});
}

TEST_F(SceneErrors, ValueThatIsNoNumberIsShownWithRangeAndUnit)
{
  expect_error(write_scene("subsection Time\n  set Time step = fast\nend\n"),
               {"scene.prm:20: ", "Time/Time step = 'fast'", "must be a number > 0 [s]"});
}

TEST_F(SceneErrors, NumbersMustLieInTheirRanges)
{
  expect_option_error("Time/Time step=0", {"Time/Time step = '0'", "must be a number > 0 [s]"});
  expect_option_error("Time/Time step=nan", {"must be a number > 0 [s]"});
  expect_option_error("Time/Time step=1e-3s", {"must be a number > 0 [s]"});
  expect_option_error("Time/Time step=", {"Time/Time step = ''", "must be a number > 0 [s]"});
  expect_option_error("Time/Dynamic coefficient=1.5", {"must be a number > 0 and <= 1"});
  expect_option_error("Materials/rock/Poisson ratio=0.5", {"must be a number > -1 and < 0.5"});
  expect_option_error("Materials/rock/Friction angle=90",
                      {"must be 'automatic' or a number >= 0 and < 90 [deg]"});
  expect_option_error("Materials/rock/Weight density=-1",
                      {"'same' or a number >= 0 and <= 1e+10 [kg/m3]"});
  expect_option_error("Materials/rock/Density=1e300", {"must be a number >= 0.001 and <= 1e+10"});
  expect_option_error("Water/Level=high",
                      {"Water/Level = 'high'", "'none' or a number >= -1e+05 and <= 1e+05 [m]"});
  expect_option_error("Continuum/Degree=9", {"an integer from 1 to 8"});
  expect_option_error("Parallel/Threads=2.5", {"Parallel/Threads = '2.5'", "an integer from 1 to"});
}

TEST_F(SceneErrors, TimeStepMustFitTheEndTime)
{
  expect_error(write_scene(),
               {"Time/Time step = '2'", "must not exceed Time/End time = 1 [s]"},
               {"Time/End time=1", "Time/Time step=2"});
  expect_error(write_scene(),
               {"Time/End time = '1e9'", "is more than 1e9 steps of Time/Time step = 0.001 [s]"},
               {"Time/End time=1e9", "Time/Time step=1e-3"});
}

TEST_F(SceneErrors, WordsMustBeAmongTheChoices)
{
  expect_option_error("Continuum/Base=soft",
                      {"Continuum/Base = 'soft'", "one of compliant | rigid | fixed"});
  expect_option_error(
    "Time/Scheme=euler",
    {"one of automatic | filtered | dissipative | trapezoidal | fourth order | shi"});
  expect_option_error("Motion/Unit=G", {"one of m/s2 | g | cm/s2 | gal"});
  expect_option_error("Blocks/Stiffness correction=maybe", {"must be true or false"});
}

TEST_F(SceneErrors, OverrideMustNameAParameterAndAValue)
{
  expect_option_error("Time/Tim step=1", {"unknown parameter 'Time/Tim step'", "'Time step'"});
  expect_option_error("Time step=1",
                      {"unknown parameter 'Time step'", "did you mean 'Time/Time step'?"});
  expect_option_error("Time/Time step", {"must have the form Section/Name=value"});
  expect_option_error("/Time step=1", {"must have the form Section/Name=value"});
}

TEST_F(SceneErrors, MissingEndNamesTheOpenSubsection)
{
  expect_error(write_scene("subsection Time\n  set End time = 1\n"),
               {"scene.prm:19: ", "subsection 'Time' is not closed", "'end' is missing"});
}

TEST_F(SceneErrors, SurplusEndIsRefused)
{
  expect_error(write_scene("end\n"), {"scene.prm:19: ", "'end' closes no subsection"});
}

TEST_F(SceneErrors, LineThatIsNoStatementIsRefused)
{
  expect_error(write_scene("Time step = 1\n"),
               {"scene.prm:19: ", "'Time step = 1' is not understood"});
  expect_error(write_scene("set Title\n"),
               {"scene.prm:19: ", "must have the form 'set NAME = VALUE'"});
}

TEST_F(SceneErrors, UnreadableFilesAreNamed)
{
  expect_error(path("absent.prm"), {"absent.prm", "cannot be read"});
  expect_error(write_scene("include absent.prm\n"),
               {"scene.prm:19: ", "absent.prm", "cannot be read"});
  expect_error(write_scene("include scene.prm\n"), {"scene.prm:19: ", "includes itself"});
  expect_error(
    write_scene("subsection Motion\n  set Type = text\n  set File = quake.txt\nend\n"),
    {"scene.prm:21: ", "Motion/File = 'quake.txt'", "there is no file", path("quake.txt")});
  write("other.txt", "0 0\n0.01 1\n0.02 0\n");
  EXPECT_NO_THROW(
    read_scene(path("scene.prm"), {"Motion/File=" + path("other.txt")})); // in its place
}

TEST_F(SceneErrors, FilesMustBeText)
{
  write_scene();
  const std::string marked = write("marked.prm", "\xef\xbb\xbfinclude scene.prm\n");
  EXPECT_NO_THROW(hybrid::scene::read_scene(marked)); // some editors begin a file so
  expect_error(write("utf16.prm", std::string("\xff\xfes\0e\0t\0", 8)),
               {"utf16.prm:1: ", "no plain text", "UTF-8"});
  expect_error(testing::TempDir(), {"is a directory, not a parameter file"});
}

TEST_F(SceneErrors, MeshMustFitTheModel)
{
  write("section.stl", "");
  const std::string empty_mesh = "Mesh/File=";
  expect_option_error(empty_mesh, {"Mesh/File", "Model/Bedrock = continuum needs a mesh"});
  expect_option_error("Mesh/File=" + path("section.stl"), {"must be a .geo or .msh file"});
  expect_option_error("Mesh/Surface file=" + path("section.geo"), {"Model/Bedrock = rigid"});
  expect_option_error("Mesh/Numbers=h: 4", {"must have the form 'name = value'"});
  expect_option_error("Mesh/Numbers=h = big", {"'big' of 'h' must be a number"});
}

TEST_F(SceneErrors, ModelWithoutBedrockAndBlocksHasNothingToSimulate)
{
  expect_error(write_scene(),
               {"Model/Blocks = 'none'", "nothing to simulate"},
               {"Model/Blocks=none", "Model/Bedrock=rigid"});
}

TEST_F(SceneErrors, BedrockOfBlocksSaysWhatItCannotDo)
{
  expect_option_error("Model/Continuum=none",
                      {"Model/Continuum", "Model/Bedrock", "rigid for none"});
  expect_error(write_scene(),
               {"Continuum/Sides", "must be viscous with Model/Bedrock = layers"},
               {"Model/Bedrock=layers", "Continuum/Sides=free field"});
  expect_error(write_scene(),
               {"Continuum/Sides", "must be viscous or free field with Model/Bedrock = triangles"},
               {"Model/Bedrock=triangles", "Continuum/Sides=roller"});
  expect_error(write_scene(),
               {"Continuum/Rayleigh mass", "must be 0 with a bedrock of blocks"},
               {"Model/Bedrock=triangles", "Continuum/Rayleigh mass=0.1"});
  expect_error(write_scene(),
               {"Bedding planes/Names", "must name the planes"},
               {"Model/Bedrock=layers", "Continuum/Sides=viscous", "Bedding planes/Names="});
  expect_error(write_scene(),
               {"Mesh/File", "a bedrock of blocks needs a mesh"},
               {"Model/Bedrock=triangles", "Mesh/File="});
  expect_error(write_scene(),
               {"Mesh/Corner levels", "must be 0", "Model/Bedrock = continuum"},
               {"Model/Bedrock=triangles", "Mesh/Corner levels=1"});
}

TEST_F(SceneErrors, MaterialsMustBeInTheTable)
{
  expect_option_error("Continuum/Materials=rok",
                      {"Continuum/Materials = 'rok'", "did you mean 'rock'?"});
  expect_option_error("Continuum/Materials=", {"needs a material"});
  expect_option_error("Continuum/Materials=bedrock: rock; bedrock: clay",
                      {"'bedrock' stands twice"});
  expect_option_error("Continuum/Half space material=granite",
                      {"no such material", "lists clay, rock"});
  expect_option_error("Blocks/Material=", {"Blocks/Material", "blocks need a material"});
  expect_option_error("Blocks/Belt material=clya",
                      {"Blocks/Belt material = 'clya'", "did you mean 'clay'?"});
  expect_option_error("Blocks/Saturated belt material=clay", {"needs Blocks/Belt material"});
}

TEST_F(SceneErrors, UnusedBlocksNeedNoMaterial)
{
  EXPECT_NO_THROW(
    hybrid::scene::read_scene(write_scene(), {"Model/Blocks=none", "Blocks/Material="}));
}

TEST_F(SceneErrors, MaterialTableMustBeConsistent)
{
  expect_error(write_scene(), {"'rock' stands twice"}, {"Materials/Names=rock, clay, rock"});
  expect_error(write_scene(), {"'sand' has no values"}, {"Materials/Names=rock, clay, sand"});
  expect_error(write_scene(),
               {"name 'wet clay' must consist of letters"},
               {"Materials/Names=rock, wet clay"});
  expect_option_error("Materials/rock/Residual cohesion=5", {"must not exceed Cohesion = 0 [Pa]"});
  expect_option_error("Materials/rock/Residual friction angle=31",
                      {"must not exceed Friction angle = 30 [deg]"});
}

TEST_F(SceneErrors, MotionMustBeComplete)
{
  expect_error(write_scene(),
               {"Motion/File", "Motion/Type = text needs the file"},
               {"Motion/Type=text"});
  expect_option_error("Motion/File=" + path("section.geo"), {"not used unless Motion/Type is set"});
  expect_error(write_scene(),
               {"Motion/Lowest frequency = '9'", "must be below Motion/Highest frequency = 8 [Hz]"},
               {"Motion/Type=synthetic", "Motion/Lowest frequency=9"});
}

TEST_F(SceneErrors, MonitorsMustBeNamedPoints)
{
  expect_option_error("Monitors/Points=S1: 1",
                      {"Monitors/Points", "'S1' has 1 numbers but must have 2"});
  expect_option_error("Monitors/Points=S1: 1, east", {"'east' of 'S1' must be a number"});
  expect_option_error("Monitors/Points=S1: 1, 2; S1: 3, 4", {"'S1' stands twice"});
  expect_option_error("Monitors/Points=a/b: 1, 2", {"name 'a/b' must consist of letters"});
  expect_option_error("Monitors/Base=S9", {"Monitors/Base = 'S9'", "no such monitor"});
  expect_option_error("Monitors/Names=S1", {"needs the CSV file"});
  expect_option_error("Boreholes/Lines=Z: 1, 2, 1, 3", {"'Z' must run vertically down"});
  expect_option_error("Boreholes/Measured=Z: 1", {"'Z' has 1 numbers but must have 2 to 3"});
  expect_option_error("Boreholes/Measured=Z: 1, 2, 3, 4", {"'Z' has 4 numbers"});
}

TEST_F(SceneErrors, MonitorFileMustHoldTheNamedRows)
{
  const std::string file =
    "Monitors/File=" + write("points.csv", "name,x,z\nS1,1,2\nS2,3,4\nS2,5,6\n");
  const std::string bad = "Monitors/File=" + write("bad.csv", "name,x,z\nS1,1\n");
  expect_error(write_scene(), {"must list the rows"}, {file});
  expect_error(write_scene(),
               {"there is no row 'S11'", "did you mean 'S1'?"},
               {file, "Monitors/Names=S11"});
  expect_error(write_scene(),
               {"points.csv:4", "'S2' stands in several rows"},
               {file, "Monitors/Names=S2"});
  expect_error(write_scene(),
               {"bad.csv:2", "must have the form name,x,z"},
               {bad, "Monitors/Names=S1"});
  expect_error(write_scene(),
               {"'S1' is a monitor of Monitors/Points already"},
               {file, "Monitors/Names=S1", "Monitors/Points=S1: 0, 0"});
}

TEST_F(SceneErrors, PathsThatAShellWouldUnderstandAreExplained)
{
  write("quake.txt", "0 0\n1 0\n");
  const auto record = [](const std::string &value) {
    return std::vector<std::string>{"Motion/File=" + value};
  };
  expect_error(write_scene("subsection Motion\n  set File = \"quake.txt\"\nend\n"),
               {"there is no file", "; leave the quotation marks away: quake.txt"});
  const std::string file = write_scene();
  expect_error(file, {"leave the quotation marks away: quake.txt"}, record("'quake.txt'"));
  expect_error(file,
               {"'~' is not replaced here, write the whole path: ", "/quake.txt"},
               record("~/quake.txt"));
  expect_error(file, {"variables are not replaced here"}, record("$HOME/quake.txt"));
  expect_error(file, {"did you mean 'quake.txt'?"}, record(path("Quake.txt")));
  expect_error(file, {"did you mean 'quake.txt'?"}, record(path("quake")));
  expect_error(file, {"it is a directory"}, record(path("")));
  expect_option_error("Output/Directory=~/output", {"'~' is not replaced here"});
  expect_option_error("Output/Directory=\"output\"", {"leave the quotation marks away: output"});
  expect_option_error("Motion/Peak=0.3 kg", {"must be", "m/s2, g, cm/s2 or gal"});
  expect_option_error("Motion/Peak=-0.3 g", {"must be"});
}

TEST_F(SceneErrors, WaterThatActsNeedsALevelAndTotalDensities)
{
  expect_error(write_scene(),
               {"Water/Method", "needs the elevation of the water in Water/Level"},
               {"Water/Method=submerged"});
  expect_error(write_scene(),
               {"Materials/clay/Weight density", "is for Water/Method = paper"},
               {"Water/Method=pressures", "Water/Level=3", "Materials/clay/Weight density=1400"});
  write("line.csv", "x,y\n0,1\n9,2\n");
  expect_error(write_scene(),
               {"Materials/clay/Weight density"},
               {"Water/Method=pressures",
                "Water/Line file=" + path("line.csv"),
                "Materials/clay/Weight density=1400"});
  expect_option_error("Heterogeneity/Modulus shape=0", {"must be", "number > 0"});
}

TEST_F(SceneErrors, WaterHasOneLevelThatActsWhereItChanges)
{
  write("level.csv", "time [s],level [m]\n0,3\n10,1\n");
  const std::string file = "Water/Level file=" + path("level.csv");
  expect_error(write_scene(),
               {"Water/Level file", "Water/Level = 3 [m]", "one of the two"},
               {file, "Water/Level=3", "Water/Method=submerged"});
  expect_error(write_scene(), {"Water/Level file", "no effect with Water/Method = paper"}, {file});
  expect_error(write_scene(),
               {"Water/Level file", "Water/Method = pressures", "continuum or rigid"},
               {file, "Water/Method=pressures", "Model/Bedrock=triangles"});
  expect_option_error("Water/Line file=" + path("none.csv"), {"none.csv", "there is no file"});
  write("level.csv", "0,3\n0,1\n");
  expect_error(write_scene(), {"level.csv:2", "time [s] = 0"}, {file, "Water/Method=submerged"});
}

TEST_F(SceneErrors, MotionsNeedWhatTheirTypeUses)
{
  expect_error(write_scene(),
               {"Motion/Spectrum file", "needs the file of a spectrum"},
               {"Motion/Type=spectrum"});
  write("target.txt", "1 1\n2 1\n");
  expect_error(write_scene("subsection Motion\n  set Spectrum file = target.txt\nend\n"),
               {"Motion/Spectrum file", "is not used unless Motion/Type is set to spectrum"});
  expect_error(write_scene(),
               {"Motion/Taper", "at most half of Motion/Cycles = 3"},
               {"Motion/Type=sine", "Motion/Cycles=3", "Motion/Taper=2"});
}

TEST_F(SceneErrors, EdgeLoadsNeedABoxAndSixNumbers)
{
  expect_option_error("Edge loads/Tractions=top: 0, 1, 2, 1, 0, -1e3",
                      {"the box of 'top' is empty", "y min <= y max"});
  expect_option_error("Edge loads/Tractions=top: 0, 1, 2", {"'top' has 3 numbers", "must have 6"});
}



TEST_F(SceneErrors, InitialVelocitiesNeedABoxSevenNumbersAndBlocks)
{
  expect_option_error("Blocks/Initial velocities=a: 0, 1, 2, 1, 0, 3, 0",
                      {"the box of 'a' is empty", "y min <= y max"});
  expect_option_error("Blocks/Initial velocities=a: 0, 1, 2", {"'a' has 3 numbers", "must have 7"});
  expect_option_error("Blocks/Initial velocities=a: 0, 1, 0, 1, 0, 1e9, 0",
                      {"'a'", "at most 1000 [m/s] and [rad/s]"});
}



TEST_F(SceneErrors, InitialWaveSaysWhatItNeeds)
{
  expect_option_error("Initial wave/Type=S", {"Initial wave/Type", "P", "SV"});
  expect_option_error("Initial wave/Centre=1", {"two numbers"});
  expect_option_error("Initial wave/Centre=1, x", {"two numbers"});
  expect_option_error("Initial wave/Length=0", {"Initial wave/Length", ">= 0.25"});
}
