// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/mesh/mesh_file_check.h>

#include "temporary_files.h"

namespace hybrid::scene::test
{
  using MeshFileCheck = TemporaryFiles;


  TEST_F(MeshFileCheck, GeometriesEndWithALineBreak)
  {
    for (const char *text : {"", "Point(1) = {0, 0, 0};\n", "a = 1;\r\n", "a = 1;\n\n  \t"})
      EXPECT_NO_THROW(check_mesh_file(write("whole.geo", text))) << text;
    EXPECT_NO_THROW(check_mesh_file(write("mesh.msh", "$EndElements")));
    expect_part(message_of([&]() {
                  check_mesh_file(write("cut.geo", "a = 1;\nPhysical Curve(\"ground\") = {5};"));
                }),
                "cut.geo:2: no line break ends the last line, 'Physical Curve(\"ground\") = {5};', "
                "and gmsh would leave it out: add one.");
    expect_part(message_of([&]() { check_mesh_file(write("long.geo", std::string(100, 'x'))); }),
                "'" + std::string(40, 'x') + "...'");
  }


  TEST_F(MeshFileCheck, OtherFilesAreRefused)
  {
    expect_part(message_of([&]() { check_mesh_file((directory / "absent.geo").string()); }),
                "there is no such mesh file");
    expect_part(message_of([&]() { check_mesh_file(write("mesh.vtk", "")); }),
                "must end in .geo or .msh");
  }
} // namespace hybrid::scene::test
