// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/section_tables.h>

#include <iterator>

namespace hybrid::output
{
  namespace
  {
    class SectionTables
    {
    public:
      SectionTables(HistoryFile                  &run_file,
                    const scene::SceneParameters &parameters,
                    const scene::SectionMesh     &section)
        : file(run_file)
        , scene(parameters)
        , mesh(section)
      {}

      void write_names()
      {
        std::string names;
        for (const auto &entry : scene.materials)
          names += (names.empty() ? "" : ", ") + entry.first;
        file.set_attribute("section", "materials", names);
      }

      void write_bedding()
      {
        for (const std::string &name : scene.bedding.names)
          {
            const auto line = mesh.lines.find(name);
            if (line == mesh.lines.end() || line->second.empty())
              continue;
            const std::vector<double> ends = coordinates(line->second);
            file.write_table("section/bedding/" + name,
                             "m",
                             ends.data(),
                             ends.size() / 4,
                             4,
                             "edges of the bedding plane, initial");
          }
      }

      void write_lines()
      {
        for (const auto &[name, edges] : mesh.lines)
          if (!edges.empty())
            {
              const std::vector<double> ends = coordinates(edges);
              file.write_table("section/lines/" + name,
                               "m",
                               ends.data(),
                               ends.size() / 4,
                               4,
                               "edges of this line of the mesh, initial");
            }
      }

      void write_cells()
      {
        std::vector<int> material;
        for (const int region : mesh.bedrock_region)
          material.push_back(number(scene.bedrock_material(mesh.bedrock_region_names[region])));
        const std::vector<double> corners = coordinates(mesh.bedrock_cells);
        file.write_table("section/cells",
                         "m",
                         corners.data(),
                         material.size(),
                         8,
                         "corners of the bedrock's cells, initial");
        file.write_integers("section/cells_material",
                            material,
                            "index into the materials of the section");
      }

      void write_blocks(const dda::Model &model)
      {
        file.set_attribute("section",
                           "mass_blocks",
                           std::vector<double>{static_cast<double>(model.n_mass())});
        std::vector<int> material;
        for (const dda::BlockProperties &block : model.blocks)
          {
            const int  rock       = block.region - static_cast<int>(mesh.block_region_names.size());
            const bool is_bedrock = static_cast<int>(material.size()) >= model.n_mass();
            material.push_back(number(
              is_bedrock
                ? scene.bedrock_material(mesh.bedrock_region_names[rock])
                : scene.mass_material(mesh.block_region_names[block.region], block.saturated)));
          }
        file.write_integers("section/blocks_material",
                            material,
                            "index into the materials of the section");
      }

      void write_belt()
      {
        const auto line = mesh.lines.find("sliding_surface");
        if (!scene.blocks.bonded || scene.blocks.belt_material.empty() || line == mesh.lines.end())
          return;
        std::vector<int> material;
        for (const auto &edge : line->second)
          {
            const Vec2 x = 0.5 * (mesh.nodes[edge[0]] + mesh.nodes[edge[1]]);
            material.push_back(
              number(scene.belt_material(x.y() < scene.environment.water_at(x.x()))));
          }
        const std::vector<double> ends = coordinates(line->second);
        file.write_table(
          "section/belt", "m", ends.data(), material.size(), 4, "edges of the belt, initial");
        file.write_integers("section/belt_material",
                            material,
                            "index into the materials of the section");
      }

    private:
      HistoryFile                  &file;
      const scene::SceneParameters &scene;
      const scene::SectionMesh     &mesh;

      template <typename Lists>
      std::vector<double> coordinates(const Lists &lists) const
      {
        std::vector<double> values;
        for (const auto &nodes : lists)
          for (const int node : nodes)
            values.insert(values.end(), {mesh.nodes[node].x(), mesh.nodes[node].y()});
        return values;
      }

      int number(const Material &material) const
      {
        auto entry = scene.materials.begin();
        while (&entry->second != &material)
          ++entry;
        return static_cast<int>(std::distance(scene.materials.begin(), entry));
      }
    };
  } // namespace



  void write_section_materials(HistoryFile                  &file,
                               const scene::SceneParameters &scene,
                               const scene::SectionMesh     &mesh,
                               const dda::Model             *model)
  {
    SectionTables tables(file, scene, mesh);
    tables.write_names();
    tables.write_bedding();
    tables.write_lines();
    if (scene.has_continuum())
      tables.write_cells();
    if (model == nullptr)
      return;
    tables.write_blocks(*model);
    tables.write_belt();
  }



  void write_surface(HistoryFile &file, const scene::SectionMesh &mesh)
  {
    const auto line = mesh.lines.find("sliding_surface");
    if (line == mesh.lines.end() || line->second.empty())
      return;
    std::vector<double> points;
    std::vector<int>    offsets;
    int                 last = -1;
    const auto          add  = [&](const int node) {
      points.insert(points.end(), {mesh.nodes[node].x(), mesh.nodes[node].y()});
      last = node;
    };
    for (const auto &edge : line->second)
      {
        if (edge[0] != last)
          {
            offsets.push_back(static_cast<int>(points.size() / 2));
            add(edge[0]);
          }
        add(edge[1]);
      }
    offsets.push_back(static_cast<int>(points.size() / 2));
    file.write_table(
      "section/surface", "m", points.data(), points.size() / 2, 2, "sliding surface");
    file.write_integers("section/surface_offsets", offsets, "first point of each of its paths");
  }
} // namespace hybrid::output
