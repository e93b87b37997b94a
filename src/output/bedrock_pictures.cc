// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/bedrock_pictures.h>

namespace hybrid::output
{
  namespace
  {
    /// The numbers of @p values, which go.
    template <typename Value>
    std::vector<double> flat(std::vector<Value> &values)
    {
      std::vector<double> numbers;
      if (!values.empty())
        numbers.reserve(values.size() * values.front().size());
      for (const Value &value : values)
        numbers.insert(numbers.end(), value.data(), value.data() + value.size());
      values = std::vector<Value>(); // {} would keep its memory
      return numbers;
    }
  } // namespace



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
    continuum::Continuum::Picture picture = continuum.picture(state);
    VtuWriter                     writer;
    writer.reserve(picture.points.size(), picture.cells.size(), 4 * picture.cells.size());
    for (std::size_t k = 0; k < picture.points.size(); ++k)
      writer.add_point(picture.points[k] + picture.displacement[k]);
    picture.points = std::vector<Vec2>();
    for (const auto &cell : picture.cells)
      writer.add_cell(CellShape::quad, cell.data(), 4);
    picture.cells = std::vector<std::array<int, 4>>();
    writer.add_point_field("displacement [m]", {"x", "y"}, flat(picture.displacement));
    writer.add_point_field("velocity [m/s]", {"x", "y"}, flat(picture.velocity));
    writer.add_cell_field("stress increment xx, yy, xy [Pa]",
                          {"xx", "yy", "xy"},
                          flat(picture.stress));
    if (picture.static_stress.size() == writer.n_cells())
      writer.add_cell_field("static stress xx, yy, xy [Pa]",
                            {"xx", "yy", "xy"},
                            flat(picture.static_stress));
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
