// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/bedrock_pictures.h>

namespace hybrid::output
{
  BedrockPictures::BedrockPictures(const continuum::Continuum &bedrock)
    : continuum(bedrock)
  {}



  void BedrockPictures::write(const continuum::ContinuumState &state,
                              const std::string               &file_name) const
  {
    VtuWriter                         writer    = draw(state);
    const continuum::Ownership *const ownership = continuum.ownership();
    if (ownership == nullptr)
      return writer.write(file_name);
    const MPI_Comm communicator = ownership->communicator();
    writer.write(from_first(file_name, communicator), communicator);
  }



  VtuWriter BedrockPictures::draw(const continuum::ContinuumState &state) const
  {
    const continuum::Continuum::Picture picture = continuum.picture(state);
    VtuWriter                           writer;
    for (std::size_t k = 0; k < picture.points.size(); ++k)
      writer.add_point(picture.points[k] + picture.displacement[k]);
    for (const auto &cell : picture.cells)
      writer.add_cell(CellShape::quad, cell.data(), 4);
    const auto pairs = [](const std::vector<Vec2> &values) {
      std::vector<double> flat;
      for (const Vec2 &v : values)
        flat.insert(flat.end(), {v.x(), v.y()});
      return flat;
    };
    const auto triples = [](const std::vector<std::array<double, 3>> &values) {
      std::vector<double> flat;
      for (const auto &v : values)
        flat.insert(flat.end(), v.begin(), v.end());
      return flat;
    };
    writer.add_point_field("displacement [m]", {"x", "y"}, pairs(picture.displacement));
    writer.add_point_field("velocity [m/s]", {"x", "y"}, pairs(picture.velocity));
    writer.add_cell_field("stress increment xx, yy, xy [Pa]",
                          {"xx", "yy", "xy"},
                          triples(picture.stress));
    if (picture.static_stress.size() == picture.cells.size())
      writer.add_cell_field("static stress xx, yy, xy [Pa]",
                            {"xx", "yy", "xy"},
                            triples(picture.static_stress));
    writer.add_cell_field("region",
                          std::vector<double>(picture.region.begin(), picture.region.end()));
    return writer;
  }



  std::string from_first(std::string text, const MPI_Comm communicator)
  {
    int length = static_cast<int>(text.size());
    MPI_Bcast(&length, 1, MPI_INT, 0, communicator);
    text.resize(length);
    MPI_Bcast(text.data(), length, MPI_CHAR, 0, communicator);
    return text;
  }
} // namespace hybrid::output
