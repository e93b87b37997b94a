// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/pvd_series.h>
#include <hybrid/output/vtu_writer.h>
#include <hybrid/restart/archive.h>

#include <stdexcept>

#include "python_check.h"

namespace hybrid::output
{
  namespace
  {
    using test::make_directory;
    using test::python_passes;

    /// One cell of each shape over five points.
    VtuWriter make_picture()
    {
      VtuWriter picture;
      for (const Vec2 &p : {Vec2(0., 0.), Vec2(2., 0.), Vec2(2., 1.), Vec2(0., 1.), Vec2(1., 1.5)})
        picture.add_point(p);
      picture.add_cell(CellShape::quad, {0, 1, 2, 3});
      picture.add_cell(CellShape::triangle, {3, 2, 4});
      picture.add_cell(CellShape::polygon, {0, 1, 2, 4, 3});
      picture.add_cell(CellShape::line, {0, 1});
      picture.add_cell(CellShape::vertex, {4});
      picture.add_point_field("displacement [m]",
                              {"x", "y"},
                              {1., 2., 3., 4., 5., 6., 7., 8., 9., 10.});
      picture.add_cell_field("stress <xx> & \"yy\" [Pa]", {1e6, -2.5e6, 3., 4., 5.});
      return picture;
    }

    /// Pictures at 0, 0.1 and 0.2 s, and one later than the checkpoint. Returns the checkpoint's
    /// content.
    std::string three_pictures(const std::string &directory)
    {
      restart::Archive checkpoint = restart::Archive::writer();
      PvdSeries        series(directory, "blocks");
      for (const double time : {0., 0.1, 0.2})
        series.add(time, make_picture());
      checkpoint(series);
      series.add(0.2, make_picture());
      return checkpoint.content();
    }

    const char reader[] = R"(
import base64, struct, zlib, xml.etree.ElementTree as xml
def array(node):
    blocks, n = struct.unpack('<QQ', base64.b64decode(node.text[:24])[:16])
    assert blocks == (1 if n else 0)
    raw = zlib.decompress(base64.b64decode(node.text[44:])) if blocks else b''
    assert n == len(raw), (n, len(raw))
    code, size = {'Float64': ('d', 8), 'Float32': ('f', 4), 'Int32': ('i', 4), 'UInt8': ('B', 1)}[node.get('type')]
    return list(struct.unpack('<%d%s' % (n // size, code), raw))
def arrays(file):
    root = xml.parse(file).getroot()
    assert root.get('header_type') == 'UInt64' and root.get('compressor') == 'vtkZLibDataCompressor'
    return root.find('.//Piece'), {node.get('Name'): (node.get('NumberOfComponents'), array(node)) for node in root.iter('DataArray')}
)";


    TEST(VtuWriter, FileHoldsPointsCellsAndFields)
    {
      const std::string directory = make_directory("vtu");
      make_picture().write(directory + "/a.vtu");
      EXPECT_FALSE(std::filesystem::exists(directory + "/a.vtu.tmp"));
      EXPECT_TRUE(python_passes(directory, std::string(reader) + R"(
piece, data = arrays('a.vtu')
assert piece.get('NumberOfPoints') == '5' and piece.get('NumberOfCells') == '5'
assert data['Points'] == ('3', [0, 0, 0, 2, 0, 0, 2, 1, 0, 0, 1, 0, 1, 1.5, 0])
assert data['connectivity'][1] == [0, 1, 2, 3, 3, 2, 4, 0, 1, 2, 4, 3, 0, 1, 4]
assert data['offsets'][1] == [4, 7, 12, 14, 15]
assert data['types'][1] == [9, 5, 7, 3, 1]
names = next(n for n in piece.iter('DataArray') if n.get('Name') == 'displacement [m]')
assert [names.get('ComponentName%d' % c) for c in range(3)] == ['x', 'y', 'z']
assert data['displacement [m]'] == ('3', [1, 2, 0, 3, 4, 0, 5, 6, 0, 7, 8, 0, 9, 10, 0])
assert data['stress <xx> & "yy" [Pa]'] == ('1', [1e6, -2.5e6, 3, 4, 5])
)"));
    }


    TEST(VtuWriter, ClearedWriterStartsAgain)
    {
      VtuWriter picture = make_picture();
      picture.clear();
      EXPECT_EQ(picture.n_points(), 0u);
      EXPECT_EQ(picture.n_cells(), 0u);
      const std::string directory = make_directory("vtu_empty");
      picture.write(directory + "/empty.vtu");
      EXPECT_TRUE(python_passes(directory, std::string(reader) + R"(
piece, data = arrays('empty.vtu')
assert piece.get('NumberOfCells') == '0' and data['Points'][1] == []
)"));
    }


    TEST(VtuWriter, FieldOfWrongSizeIsRefused)
    {
      VtuWriter picture = make_picture();
      picture.add_cell_field("short", {"x", "y"}, {1., 2.});
      EXPECT_THROW(picture.write(make_directory("vtu_wrong") + "/a.vtu"), std::logic_error);
    }


    TEST(PvdSeries, IsValidAfterEachPictureAndListsExistingFiles)
    {
      const std::string directory = make_directory("pvd");
      PvdSeries         series(directory, "blocks");
      const VtuWriter   picture = make_picture();
      for (int i = 0; i < 3; ++i)
        {
          series.add(0.1 * i, picture);
          EXPECT_TRUE(python_passes(directory, "n = " + std::to_string(i + 1) + std::string(R"(
import os, xml.etree.ElementTree as xml
sets = xml.parse('blocks.pvd').getroot().findall('Collection/DataSet')
assert [float(s.get('timestep')) for s in sets] == [0.1 * i for i in range(n)]
for s in sets:
    assert s.get('file').startswith('vtu/blocks_')
    xml.parse(s.get('file'))
assert not os.path.exists('blocks.pvd.tmp')
)")));
        }
    }


    TEST(PvdSeries, ResumeLeavesOutPicturesThatAreGone)
    {
      const std::string directory  = make_directory("pvd_gone");
      const std::string checkpoint = three_pictures(directory);
      std::filesystem::remove(directory + "/vtu/blocks_00001.vtu");
      PvdSeries        series(directory, "blocks");
      restart::Archive stored = restart::Archive::reader(checkpoint);
      stored(series);
      EXPECT_EQ(series.missing_files(), std::vector<std::string>{"vtu/blocks_00001.vtu"});
      series.add(0.35, make_picture());
      EXPECT_TRUE(python_passes(directory, R"(
import xml.etree.ElementTree as xml
sets = xml.parse('blocks.pvd').getroot().findall('Collection/DataSet')
assert [(float(s.get('timestep')), s.get('file')[-9:]) for s in sets] == \
    [(0., '00000.vtu'), (0.2, '00002.vtu'), (0.35, '00003.vtu')]
)"));
    }


    TEST(PvdSeries, ResumeKeepsPicturesUpToTheCheckpoint)
    {
      const std::string directory  = make_directory("pvd_resume");
      const std::string checkpoint = three_pictures(directory);
      PvdSeries         series(directory, "blocks");
      restart::Archive  stored = restart::Archive::reader(checkpoint);
      stored(series);
      series.add(0.35, make_picture());
      EXPECT_TRUE(python_passes(directory, R"(
import xml.etree.ElementTree as xml
sets = xml.parse('blocks.pvd').getroot().findall('Collection/DataSet')
assert [(float(s.get('timestep')), s.get('file')[-9:]) for s in sets] == \
    [(0., '00000.vtu'), (0.1, '00001.vtu'), (0.2, '00002.vtu'), (0.35, '00003.vtu')]
)"));
    }
  } // namespace
} // namespace hybrid::output
