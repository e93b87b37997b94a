// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/plot_command.h>
#include <hybrid/scene/input_error.h>

#include "python_check.h"

namespace hybrid::output
{
  namespace
  {
    using test::make_directory;
    using test::python_passes;

    /// Run a helper of this folder that makes a synthetic run in @p directory.
    bool make_run(const std::string &directory, const std::string &kind)
    {
      return std::system(("'" HYBRID_PYTHON "' '" OUTPUT_TEST_DIR "/make_synthetic_run.py' '" +
                          directory + "' " + kind)
                           .c_str()) == 0;
    }


    TEST(PlotCommand, DrawsEveryFigureOfACompleteRun)
    {
      const std::string directory = make_directory("plot");
      ASSERT_TRUE(make_run(directory, "complete"));
      EXPECT_EQ(plot(directory), 0);
      EXPECT_TRUE(python_passes(directory, R"(
import os
names = ['overview', 'input_motion', 'monitors_S', 'monitors_D', 'monitors_base', 'boreholes', 'section', 'slip', 'energy', 'steps']
assert sorted(os.listdir('figures')) == sorted(n + '.png' for n in names), os.listdir('figures')
for n in names:
    with open('figures/' + n + '.png', 'rb') as f:
        assert f.read(8) == b'\x89PNG\r\n\x1a\n'
)"));
    }


    TEST(PlotCommand, ARunWithoutBlocksOrBoreholesIsDrawnAsFarAsItGoes)
    {
      const std::string directory = make_directory("plot_bare");
      ASSERT_TRUE(make_run(directory, "bare"));
      EXPECT_EQ(plot(directory), 0);
      EXPECT_TRUE(python_passes(directory, R"(
import os
assert sorted(os.listdir('figures')) == ['monitors_other.png', 'overview.png'], os.listdir('figures')
)"));
    }


    TEST(PlotCommand, BlocksThatAllLeftTheSectionAreDrawnWhereTheyAre)
    {
      const std::string directory = make_directory("plot_away");
      ASSERT_TRUE(make_run(directory, "away"));
      EXPECT_EQ(plot(directory), 0);
      EXPECT_TRUE(python_passes(directory, R"(
import os
assert 'section.png' in os.listdir('figures'), os.listdir('figures')
)"));
    }


    TEST(PlotCommand, MissingModulesAreASentenceAndEffectsThatAreOffAreNoWords)
    {
      const std::string directory = make_directory("plot_words");
      ASSERT_TRUE(make_run(directory, "complete"));
      EXPECT_TRUE(python_passes(directory, R"(
import subprocess, sys
script = ')" OUTPUT_TEST_DIR R"(/../../../src/output/plot/plot_run.py'
def say(*options):
    end = subprocess.run([sys.executable, *options, script, '.'], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return end.returncode, end.stdout
code, words = say('-S') # without the modules that Debian installs
assert code == 1 and 'python3-h5py' in words and 'Traceback' not in words and words.count('\n') == 1, words
code, words = say()
assert code == 0 and words == 'figures: ./figures\n', words
)"));
    }


    TEST(PlotCommand, BoreholesAreExplainedAndNoWordsLieOnTheirCurves)
    {
      const std::string directory = make_directory("plot_boreholes");
      ASSERT_TRUE(make_run(directory, "complete"));
      EXPECT_TRUE(python_passes(directory, R"(
import sys
import h5py
sys.path.insert(0, ')" OUTPUT_TEST_DIR R"(/../../../src/output/plot')
import boreholes, numpy, overview, style
from run_data import RunData
figures = []
style.save = lambda figure, *_: figures.append(figure)

def legends(part):
    own = [[t.get_text() for t in l.get_texts()] for l in part.legends]
    return own + [l for p in getattr(part, 'subfigs', []) for l in legends(p)]

def words_are_free(figure):
    figure.canvas.draw()
    for axes in figure.axes:
        words = [t for t in axes.texts if t.get_text() == 'sliding surface'][0].get_window_extent()
        for line in axes.lines[:2]: # at the peak, left at the end
            points = line.get_xydata()
            fine = numpy.linspace(0, len(points) - 1, 2000)
            points = numpy.column_stack([numpy.interp(fine, range(len(points)), points[:, c]) for c in (0, 1)])
            points = axes.transData.transform(points)
            inside = (points[:, 0] > words.x0) & (points[:, 0] < words.x1) & (points[:, 1] > words.y0) & (points[:, 1] < words.y1)
            assert not inside.any(), line.get_label()

for is_deep in (False, True): # most displacement at the ground, at the sliding surface
    if is_deep:
        with h5py.File('run.h5', 'r+') as file:
            for name in file['profiles']:
                series = file['profiles/%s/displacement' % name]
                u = series[:]
                series[:] = u.reshape(len(u), -1, 2)[:, ::-1].reshape(u.shape)
    boreholes.draw(RunData('.'), '.')
    words_are_free(figures.pop())
overview.draw(RunData('.'), '.')
assert ['envelope of the run', 'at peak of surface', 'left: mean of the last 2 s', 'measured'] in legends(figures.pop()), 'no legend'
)"));
    }


    TEST(PlotCommand, WrongDirectoriesAreInputErrors)
    {
      EXPECT_THROW(plot("/no/such/directory"), InputError);
      EXPECT_THROW(plot(make_directory("plot_empty")), InputError);
    }


    // Follows "Adding a picture" of doc/developer_guide.md: a module and a word in FIGURES.
    TEST(PlotCommand, ANewPictureIsAModuleAndAWord)
    {
      const std::string directory = make_directory("plot_new");
      ASSERT_TRUE(make_run(directory, "complete"));
      EXPECT_TRUE(python_passes(directory, R"(
import os, re, shutil, subprocess, sys
shutil.copytree(')" OUTPUT_TEST_DIR R"(/../../../src/output/plot', 'plot')
with open('plot/how_long.py', 'w') as module:
    module.write("""
import os

import matplotlib.pyplot as plt


def draw(run, directory):
    figure, axes = plt.subplots()
    axes.plot(run.file['time'][:])
    figure.savefig(os.path.join(directory, 'how_long.png'))
""")
with open('plot/plot_run.py') as file:
    text = file.read()
with open('plot/plot_run.py', 'w') as file:
    file.write(text.replace('FIGURES = (', 'FIGURES = ("how_long", '))
subprocess.run([sys.executable, 'plot/plot_run.py', '.'], check=True)
assert {'how_long.png', 'overview.png'} <= set(os.listdir('figures')), os.listdir('figures')
)"));
    }
  } // namespace
} // namespace hybrid::output
