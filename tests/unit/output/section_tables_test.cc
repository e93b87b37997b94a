// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/section_tables.h>

#include "python_check.h"

namespace hybrid::output
{
  namespace
  {
    TEST(SectionTables, TheSlidingSurfaceHasItsPathsApart)
    {
      const std::string  directory = test::make_directory("surface");
      scene::SectionMesh mesh;
      mesh.nodes = {{0., 5.}, {1., 4.}, {2., 2.}, {7., 2.}, {9., 6.}};
      {
        HistoryFile file(directory + "/run.h5");
        write_surface(file, mesh); // none
        mesh.lines["sliding_surface"] = {{0, 1}, {1, 2}, {3, 4}};
        write_surface(file, mesh);
      }
      EXPECT_TRUE(test::python_passes(directory, R"(
import h5py
with h5py.File("run.h5", "r") as file:
    assert file["section/surface"][:].tolist() == [[0, 5], [1, 4], [2, 2], [7, 2], [9, 6]]
    assert file["section/surface_offsets"][:].tolist() == [0, 3, 5]
)"));
    }
  } // namespace
} // namespace hybrid::output
