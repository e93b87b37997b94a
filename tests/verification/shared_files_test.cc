// SPDX-License-Identifier: GPL-3.0-or-later
// Run on several ranks: files that they write together are those of one alone.
#include <gtest/gtest.h>

#include <hybrid/continuum/ownership.h>
#include <hybrid/output/history_file.h>
#include <hybrid/output/shared_tables.h>
#include <hybrid/output/vtu_writer.h>
#include <hybrid/restart/checkpoint_file.h>
#include <hybrid/restart/durable_file.h>
#include <hybrid/restart/first_process_failed.h>
#include <hybrid/restart/shared_checkpoint.h>
#include <hybrid/restart/shared_file.h>
#include <hybrid/restart/write_error.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sys/resource.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;

  int rank()
  {
    int number = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &number);
    return number;
  }



  int ranks()
  {
    int number = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &number);
    return number;
  }



  std::string content(const std::string &file_name)
  {
    std::ifstream file(file_name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }



  /// An empty directory, the same on all ranks.
  std::string make_directory(const std::string &name)
  {
    const std::string directory = "shared_files_" + name;
    if (rank() == 0)
      {
        std::filesystem::remove_all(directory);
        std::filesystem::create_directory(directory);
      }
    MPI_Barrier(MPI_COMM_WORLD);
    return directory;
  }



  /// Nodes are dealt out like cards, so that all portions have something of everybody.
  Ownership dealt_out(const int n)
  {
    std::vector<int> unknowns;
    for (int node = 0; node < n; ++node)
      if (node * 7 % ranks() == rank())
        unknowns.insert(unknowns.end(), {2 * node, 2 * node + 1});
    return {unknowns, static_cast<std::size_t>(n), MPI_COMM_WORLD};
  }



  std::vector<double> roots(const std::size_t n)
  {
    std::vector<double> values(n);
    for (std::size_t i = 0; i < n; ++i)
      values[i] = std::sqrt(static_cast<double>(i));
    return values;
  }



  std::vector<double> own_of(const std::vector<double> &all, const Ownership &ownership)
  {
    return ownership.read(reinterpret_cast<const char *>(all.data()));
  }



  std::vector<double> part(const std::vector<double> &all, const Portion &nodes, const int width)
  {
    return {all.begin() + nodes.begin * width, all.begin() + nodes.end * width};
  }
} // namespace



TEST(Portion, portions_of_all_ranks_are_all)
{
  for (const std::size_t n : {0, 1, 2, 3, 7, 100})
    for (const int count : {1, 2, 3, 8})
      {
        std::size_t end = 0;
        for (int r = 0; r < count; ++r)
          {
            const Portion portion = portion_of(n, r, count);
            EXPECT_EQ(portion.begin, end);
            end = portion.end;
            if (r + 1 < count && portion_of(n, r + 1, count).size() > 0)
              {
                EXPECT_EQ(portion.size(), portion_size(n, count));
              }
          }
        EXPECT_EQ(end, n);
      }
}



TEST(Ownership, a_portion_has_the_numbers_of_its_owners)
{
  for (const int n : {2, 101})
    {
      const Ownership           ownership = dealt_out(n);
      const std::vector<double> all       = roots(2 * n);
      const std::vector<double> own       = own_of(all, ownership);
      std::vector<double>       portion;
      ownership.to_portion(own.data(), 2, portion);
      EXPECT_EQ(portion, part(all, ownership.portion(), 2));
    }
}



TEST(NodeExchange, brings_what_is_wanted_in_its_order)
{
  const Ownership           ownership = dealt_out(50);
  const std::vector<double> all       = roots(100);
  const std::vector<double> own       = own_of(all, ownership);
  std::vector<int>          wanted;
  for (int k = 0; k < 20 + rank(); ++k)
    wanted.push_back(k * 11 % 50);
  std::vector<double> found(2 * wanted.size());
  ownership.exchange(wanted).bring(own.data(), 2, found.data());
  for (std::size_t k = 0; k < wanted.size(); ++k)
    for (int c = 0; c < 2; ++c)
      EXPECT_EQ(found[2 * k + c], all[2 * wanted[k] + c]);
}



TEST(SharedFile, has_all_parts_or_stays_as_it_was)
{
  const std::string directory = make_directory("file"), name = directory + "/file";
  {
    restart::SharedFile file(name, MPI_COMM_WORLD);
    file.write(3 * rank(), std::string(3, static_cast<char>('a' + rank())));
    file.finish(true);
  }
  MPI_Barrier(MPI_COMM_WORLD);
  const std::string known = content(name);
  ASSERT_EQ(known.size(), 3u * ranks());
  EXPECT_EQ(known.substr(0, 6), "aaabbb");
  {
    restart::SharedFile abandoned(name, MPI_COMM_WORLD);
    abandoned.write(0, "x");
  }
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_EQ(content(name), known);
  EXPECT_FALSE(std::filesystem::exists(restart::temporary_name(name)));
}



TEST(SharedFile, the_first_rank_tells_what_any_fails_at)
{
  const std::string directory = make_directory("failing");
  const auto        fails     = [](const auto &work) {
    if (rank() == 0)
      EXPECT_THROW(work(), WriteError);
    else
      EXPECT_THROW(work(), FirstProcessFailed);
  };
  fails([&] { restart::SharedFile(directory + "/nowhere/file", MPI_COMM_WORLD); });
  fails([&] {
    restart::SharedFile file(directory + "/file", MPI_COMM_WORLD);
    if (rank() == ranks() - 1) // no file is so long
      file.write(std::uint64_t{1} << 62, "x");
    file.finish(false);
  });
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_TRUE(std::filesystem::is_empty(directory));
}



namespace
{
  /// A row of squares, of which this rank has a part.
  output::VtuWriter squares(const Portion &nodes, const Portion &cells)
  {
    output::VtuWriter   picture;
    std::vector<double> heights, numbers;
    for (std::size_t k = nodes.begin; k < nodes.end; ++k)
      {
        picture.add_point({static_cast<double>(k / 2), static_cast<double>(k % 2)});
        heights.push_back(std::sin(static_cast<double>(k)));
      }
    for (std::size_t c = cells.begin; c < cells.end; ++c)
      {
        const int first = static_cast<int>(2 * c);
        picture.add_cell(output::CellShape::quad, {first, first + 2, first + 3, first + 1});
        numbers.push_back(static_cast<double>(c));
      }
    picture.add_point_field("height", std::move(heights));
    picture.add_cell_field("number", std::move(numbers));
    return picture;
  }
} // namespace



// Read back in processes_test.py, too, with VTK.
TEST(SharedVtu, readers_find_the_picture_of_one_rank)
{
  const std::string directory = make_directory("vtu");
  for (const std::size_t n : {1, 2, 500})
    {
      const std::string name = directory + "/" + std::to_string(n);
      if (rank() == 0)
        squares({0, 2 * n + 2}, {0, n}).write(name + "_alone.vtu");
      squares(portion_of(2 * n + 2, rank(), ranks()), portion_of(n, rank(), ranks()))
        .write(name + "_shared.vtu", MPI_COMM_WORLD);
    }
  MPI_Barrier(MPI_COMM_WORLD);
  if (rank() > 0)
    return;
  std::ofstream(directory + "/check.py") << R"(
import sys
sys.path.insert(0, sys.argv[1])
from hybrid_run.pictures import Picture
import vtk
from vtk.util.numpy_support import vtk_to_numpy
def by_vtk(name):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(name)
    reader.Update()
    grid = reader.GetOutput()
    return [vtk_to_numpy(a) for a in (grid.GetPoints().GetData(), grid.GetPointData().GetArray(0), grid.GetCellData().GetArray(0), grid.GetCells().GetData())]
for n in (1, 2, 500):
    one, other = (by_vtk('%d_%s.vtu' % (n, kind)) for kind in ('alone', 'shared'))
    assert len(one[2]) == n and len(one[0]) == 2 * n + 2
    assert all((a == b).all() for a, b in zip(one, other)), n
    one, other = (Picture('%d_%s.vtu' % (n, kind)) for kind in ('alone', 'shared'))
    assert (one.points == other.points).all() and (one.connectivity == other.connectivity).all() and (one.starts == other.starts).all()
    assert all((one.fields[name] == other.fields[name]).all() for name in ('height', 'number')) and len(other.fields) == 2
)";
  const std::string command = "cd " + directory + " && /usr/bin/python3 check.py " HYBRID_TOOLS;
  EXPECT_EQ(std::system(command.c_str()), 0);
}



TEST(SharedTables, a_reader_finds_the_rows_of_all)
{
  const std::string directory = make_directory("tables"), name = directory + "/run.h5";
  const auto        declare = [&](output::HistoryFile &file) {
    file.set_attribute("/", "title", "a run");
    file.write_table("kept", "m", roots(5).data(), 5, 1);
  };
  constexpr std::size_t n = 1001;
  if (rank() == 0)
    {
      output::HistoryFile file(name);
      declare(file);
      file.flush();
      file.declare_table("fields/pairs", "m/s", n, 2, "of all");
      file.declare_table("fields/singles", "m", n, 1, "of all");
      file.close_into(restart::temporary_name(name));
    }
  MPI_Barrier(MPI_COMM_WORLD);
  const Portion        rows = portion_of(n, rank(), ranks());
  output::SharedTables tables(name, 3 * n * sizeof(double), MPI_COMM_WORLD);
  tables.write("fields/pairs", 2, part(roots(2 * n), rows, 2));
  tables.write("fields/singles", 1, part(roots(n), rows, 1));
  tables.finish();
  MPI_Barrier(MPI_COMM_WORLD);
  if (rank() > 0)
    return;
  EXPECT_FALSE(std::filesystem::exists(restart::temporary_name(name)));
  std::ofstream(directory + "/check.py") << R"(
import h5py, numpy
with h5py.File('run.h5') as file:
    assert file.attrs['title'] == 'a run' and file['fields/pairs'].attrs['unit'] == 'm/s'
    known = numpy.sqrt(numpy.arange(2002.))
    assert (file['fields/pairs'][()].ravel() == known).all() and (file['fields/singles'][()] == known[:1001]).all()
    assert (file['kept'][()] == known[:5]).all()
)";
  EXPECT_EQ(std::system(("cd " + directory + " && /usr/bin/python3 check.py").c_str()), 0);
}



TEST(SharedTables, a_full_disk_is_told_before_anything_is_written)
{
  const std::string     directory = make_directory("full"), name = directory + "/run.h5";
  constexpr std::size_t n = 100000;
  if (rank() == 0)
    {
      output::HistoryFile file(name);
      file.write_table("kept", "m", roots(5).data(), 5, 1);
      file.flush();
      file.declare_table("table", "m", n, 1, "of all");
      file.close_into(restart::temporary_name(name));
    }
  MPI_Barrier(MPI_COMM_WORLD);
  const std::string known = content(name);
  std::signal(SIGXFSZ, SIG_IGN); // as in a run
  rlimit limit;
  getrlimit(RLIMIT_FSIZE, &limit);
  const rlim_t before = limit.rlim_cur;
  limit.rlim_cur      = n; // bytes
  setrlimit(RLIMIT_FSIZE, &limit);
  const auto open = [&] { output::SharedTables(name, n * sizeof(double), MPI_COMM_WORLD); };
  if (rank() == 0)
    EXPECT_THROW(open(), WriteError);
  else
    EXPECT_THROW(open(), FirstProcessFailed);
  limit.rlim_cur = before;
  setrlimit(RLIMIT_FSIZE, &limit);
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_EQ(content(name), known);
  EXPECT_FALSE(std::filesystem::exists(restart::temporary_name(name)));
}



TEST(SharedCheckpoint, has_the_bytes_of_one_rank_and_is_read_by_each_for_itself)
{
  const std::string   directory = make_directory("checkpoint"), name = directory + "/state";
  const Ownership     ownership = dealt_out(203);
  const std::size_t   n         = 2 * ownership.n_nodes();
  std::vector<double> whole     = roots(2 * (n + 3)), nothing, own[2]; // two blocks of n and three
  const auto          write     = [&](restart::Archive &archive) {
    archive.put(std::string("before"));
    archive(nothing, whole);
    archive.put(std::string("behind"));
  };
  for (int b = 0; b < 2; ++b)
    own[b] = ownership.read(reinterpret_cast<const char *>(&whole[b * (n + 3)]));
  restart::SharedVector vector{&whole, 2, n, 3, {}, {}, {}}, none{&nothing, 1, n, 0, {}, {}, {}};
  none.is_empty  = true;
  vector.portion = [&](const std::size_t b) {
    std::vector<double> portion;
    ownership.to_portion(own[b].data(), 2, portion);
    return portion;
  };
  vector.rest = [&](const std::size_t b) { return &whole[b * (n + 3) + n]; };
  restart::write_shared_checkpoint(name, 5, write, {none, vector}, MPI_COMM_WORLD);
  if (rank() == 0)
    restart::write_checkpoint(name + "_alone", 5, write);
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_EQ(content(name), content(name + "_alone"));

  std::vector<double> found[2];
  vector.take = [&](const std::size_t b, const char *numbers) {
    found[b] = ownership.read(numbers);
  };
  none.take = [](std::size_t, const char *) { FAIL() << "there is nothing to take"; };
  const restart::CheckpointContent         content = restart::read_checkpoint(name);
  restart::Archive                         archive = restart::Archive::reader_of(content.state);
  const std::vector<restart::SharedVector> vectors{none, vector};
  restart::SharedReading                   reading(archive, vectors);
  if (rank() == 0) // the others need not
    {
      std::string before, behind;
      archive(before, nothing, whole, behind);
      EXPECT_EQ(before + behind, "beforebehind");
      EXPECT_TRUE(archive.at_end());
    }
  reading.take(content.state, MPI_COMM_WORLD);
  EXPECT_EQ(found[0], own[0]);
  EXPECT_EQ(found[1], own[1]);
}
