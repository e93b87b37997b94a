// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/history_file.h>
#include <hybrid/restart/archive.h>
#include <hybrid/restart/write_error.h>
#include <hybrid/scene/input_error.h>

#include <csignal>

#include <sys/wait.h>

#include "python_check.h"

namespace hybrid::output
{
  namespace
  {
    using test::make_directory;
    using test::python_passes;
    using test::read_text;

    /// Rows k = 0, 1, ...: time = k / 1000, velocity = (k, -k).
    void write_rows(HistoryFile &file,
                    const int    time,
                    const int    velocity,
                    const int    begin,
                    const int    end)
    {
      for (int k = begin; k < end; ++k)
        {
          const double t      = 1e-3 * k;
          const double pair[] = {1. * k, -1. * k};
          file.append(time, &t);
          file.append(velocity, pair);
        }
    }


    TEST(HistoryFile, SeriesTablesAndAttributesAreReadByH5py)
    {
      const std::string directory = make_directory("round_trip");
      {
        HistoryFile file(directory + "/run.h5");
        const int   time     = file.add_series("time", "s", 1, "end of each step");
        const int   velocity = file.add_series("monitors/S1/velocity", "m/s", 2, "of the point");
        write_rows(file, time, velocity, 0, 1777);
        EXPECT_EQ(file.rows(velocity), 1777u);
        const double table[] = {1., 2., 3., 4., 5., 6.};
        file.write_table("section/surface", "m", table, 1, 2);
        file.write_table("section/surface", "m", table, 3, 2, "replaces the first");
        file.write_table("section/empty", "m", table, 0, 2);
        file.write_integers("section/offsets", {0, 4, 7}, "first vertex");
        file.write_table("section/outdated", "m", table, 3, 2);
        file.write_table("joints/outdated", "m", table, 3, 2);
        for (const char *path : {"section/outdated", "joints", "nothing/there"})
          file.remove(path);
        file.set_attribute("monitors/S1", "position", std::vector<double>{206., 134.6});
        file.set_attribute("/", "title", "first");
        file.set_attribute("/", "title", "Gefälle 20°, 175 m");
        file.set_attribute("profiles/ZK1", "note", "");
      }
      EXPECT_TRUE(python_passes(directory, R"(
import h5py, numpy as np
f = h5py.File('run.h5', 'r')
k = np.arange(1777)
assert f['time'].shape == (1777,) and np.array_equal(f['time'][:], 1e-3 * k)
v = f['monitors/S1/velocity']
assert np.array_equal(v[:], np.column_stack([k, -k])), v
assert v.attrs['unit'] == 'm/s' and v.attrs['description'] == 'of the point' and type(v.attrs['unit']) is str
assert np.array_equal(f['section/surface'][:], [[1, 2], [3, 4], [5, 6]])
assert f['section/empty'].shape == (0, 2)
assert f['section/offsets'].dtype == np.int32 and f['section/offsets'][:].tolist() == [0, 4, 7]
assert f['section/offsets'].attrs['unit'] == '1' and f['section/offsets'].attrs['description'] == 'first vertex'
assert sorted(f['section']) == ['empty', 'offsets', 'surface'] and 'joints' not in f
assert np.array_equal(f['monitors/S1'].attrs['position'], [206., 134.6])
assert f.attrs['title'] == 'Gefälle 20°, 175 m' and f['profiles/ZK1'].attrs['note'] == ''
kind = h5py.check_string_dtype(f.attrs.get_id('title').dtype)
assert kind.encoding == 'utf-8' and kind.length is None, kind
)"));
    }


    TEST(HistoryFile, IsReadableDuringTheRun)
    {
      const std::string directory = make_directory("live");
      HistoryFile       file(directory + "/run.h5");
      const int         time     = file.add_series("time", "s", 1, "");
      const int         velocity = file.add_series("velocity", "m/s", 2, "");
      write_rows(file, time, velocity, 0, 10);
      file.flush();
      write_rows(file, time, velocity, 10, 5000);
      EXPECT_TRUE(python_passes(directory, R"(
import h5py
f = h5py.File('run.h5', 'r')
assert f['time'].shape == (10,) and f['velocity'][9, 1] == -9
)"));
    }


    /// Flushes a few times, goes on for a while (full buffers are written), and dies without
    /// notice.
    [[noreturn]] void
    write_and_die(const std::string &directory, const int n_flushed, const int n_lost)
    {
      HistoryFile file(directory + "/run.h5");
      const int   time     = file.add_series("time", "s", 1, "");
      const int   velocity = file.add_series("velocity", "m/s", 2, "");
      int         others[20];
      for (int i = 0; i < 20; ++i)
        others[i] = file.add_series("other/" + std::to_string(i), "1", 3, "");
      for (int k = 0; k < n_flushed + n_lost; ++k)
        {
          write_rows(file, time, velocity, k, k + 1);
          const double values[] = {1. * k, 2. * k, 3. * k};
          for (const int other : others)
            file.append(other, values);
          if (k + 1 == n_flushed / 3 || k + 1 == n_flushed)
            file.flush();
        }
      kill(getpid(), SIGKILL);
      std::abort();
    }


    TEST(HistoryFile, AKilledProcessLeavesEverythingUpToTheLastFlush)
    {
      const std::string directory = make_directory("killed");
      const int         n_lost[]  = {0, 100, 1000, 10000, 100000};
      for (int run = 0; run < 5; ++run)
        {
          const std::string here = directory + "/" + std::to_string(run);
          std::filesystem::create_directories(here);
          const pid_t child = fork();
          ASSERT_GE(child, 0);
          if (child == 0)
            write_and_die(here, 3000 + run, n_lost[run]);
          int status = 0;
          waitpid(child, &status, 0);
          ASSERT_TRUE(WIFSIGNALED(status));
          ASSERT_EQ(WTERMSIG(status), SIGKILL);
        }
      EXPECT_TRUE(python_passes(directory, R"(
import h5py, numpy as np
for run in range(5):
    flushed = 3000 + run
    f = h5py.File('%d/run.h5' % run, 'r')
    k = np.arange(flushed)
    assert f['time'].shape == (flushed,) and f['velocity'].shape == (flushed, 2)
    assert np.array_equal(f['time'][:], 1e-3 * k)
    assert np.array_equal(f['velocity'][:, 1], -k)
    for i in range(20):
        assert np.array_equal(f['other/%d' % i][:, 2], 3. * k), (run, i)
)"));
    }


    TEST(HistoryFile, AResumedFileEqualsAnUninterruptedOne)
    {
      const std::string directory = make_directory("resume");
      {
        HistoryFile file(directory + "/whole.h5");
        const int   time   = file.add_series("time", "s", 1, ""),
                  velocity = file.add_series("v", "m/s", 2, "");
        write_rows(file, time, velocity, 0, 3000);
      }
      {
        HistoryFile file(directory + "/run.h5");
        const int   time   = file.add_series("time", "s", 1, ""),
                  velocity = file.add_series("v", "m/s", 2, "");
        write_rows(file, time, velocity, 0, 1500);
      }
      {
        HistoryFile file(directory + "/run.h5", HistoryFile::Mode::resume);
        const int   time   = file.add_series("time", "s", 1, ""),
                  velocity = file.add_series("v", "m/s", 2, "");
        EXPECT_EQ(file.rows(time), 1500u);
        file.truncate(time, 1203);
        file.truncate(velocity, 1203);
        EXPECT_EQ(file.rows(velocity), 1203u);
        write_rows(file, time, velocity, 1203, 3000);
      }
      EXPECT_TRUE(python_passes(directory, R"(
import h5py
a, b = h5py.File('run.h5', 'r'), h5py.File('whole.h5', 'r')
for name in ('time', 'v'):
    assert a[name][:].tobytes() == b[name][:].tobytes()
)"));
    }


    TEST(HistoryFile, ACheckpointCutsTheSeriesWhereTheyWere)
    {
      const std::string directory  = make_directory("checkpoint");
      restart::Archive  checkpoint = restart::Archive::writer();
      {
        HistoryFile file(directory + "/run.h5");
        const int   time   = file.add_series("time", "s", 1, ""),
                  velocity = file.add_series("v", "m/s", 2, "");
        write_rows(file, time, velocity, 0, 700);
        file.flush();
        checkpoint(file);
        write_rows(file, time, velocity, 700, 1500);
      }
      HistoryFile file(directory + "/run.h5", HistoryFile::Mode::resume);
      const int   time        = file.add_series("time", "s", 1, ""),
                velocity      = file.add_series("v", "m/s", 2, "");
      restart::Archive stored = restart::Archive::reader(checkpoint.content());
      stored(file);
      EXPECT_EQ(file.rows(time), 700u);
      write_rows(file, time, velocity, 700, 702);
      const std::vector<double> values = file.read(velocity);
      ASSERT_EQ(values.size(), 2 * 702u);
      for (int k = 0; k < 702; ++k)
        EXPECT_EQ(values[2 * k + 1], -1. * k);

      HistoryFile      shorter(directory + "/shorter.h5");
      restart::Archive again = restart::Archive::reader(checkpoint.content());
      shorter.add_series("time", "s", 1, "");
      shorter.add_series("v", "m/s", 2, "");
      EXPECT_THROW(again(shorter), InputError);
    }


    TEST(HistoryFile, AFailedFlushLeavesTheOneBefore)
    {
      const std::string directory = make_directory("failed");
      {
        HistoryFile file(directory + "/run.h5");
        const int   time     = file.add_series("time", "s", 1, "");
        const int   velocity = file.add_series("velocity", "m/s", 2, "");
        write_rows(file, time, velocity, 0, 10);
        file.flush();
        std::filesystem::create_directories(directory + "/run.h5.tmp/in_the_way");
        write_rows(file, time, velocity, 10, 5000);
        EXPECT_THROW(file.flush(), WriteError);
      }
      EXPECT_TRUE(python_passes(directory, R"(
import h5py
f = h5py.File('run.h5', 'r')
assert f['time'].shape == (10,) and f['velocity'][9, 1] == -9
)"));
    }


    TEST(HistoryFile, EqualCallsGiveEqualBytes)
    {
      const std::string directory = make_directory("bytes");
      for (const std::string name : {"/a.h5", "/b.h5"})
        {
          HistoryFile file(directory + name);
          const int   time   = file.add_series("time", "s", 1, ""),
                    velocity = file.add_series("v", "m/s", 2, "");
          write_rows(file, time, velocity, 0, 2000);
          const double value = 1.;
          file.write_table("one", "1", &value, 1, 1);
          if (name == "/a.h5")
            usleep(1100000); // time stamps have a resolution of 1 s
        }
      EXPECT_EQ(read_text(directory + "/a.h5"), read_text(directory + "/b.h5"));
    }


    TEST(HistoryFile, MistakesOfTheUserAreInputErrors)
    {
      EXPECT_THROW(HistoryFile("/no/such/directory/run.h5"), InputError);
      const std::string directory = make_directory("mistakes");
      EXPECT_THROW(HistoryFile(directory + "/run.h5", HistoryFile::Mode::resume), InputError);
      {
        HistoryFile file(directory + "/run.h5");
        file.add_series("v", "m/s", 2, "");
      }
      HistoryFile file(directory + "/run.h5", HistoryFile::Mode::resume);
      EXPECT_THROW(file.add_series("v", "m/s", 3, ""), InputError);
      EXPECT_THROW(file.add_series("v", "m/s", 1, ""), InputError);
    }
  } // namespace
} // namespace hybrid::output
