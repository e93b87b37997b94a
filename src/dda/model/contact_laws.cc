// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/geometry/outline_frames.h>
#include <hybrid/dda/model/block_materials.h>
#include <hybrid/dda/model/contact_laws.h>

#include <algorithm>
#include <limits>
#include <map>

namespace hybrid::dda
{
  namespace
  {
    using scene::SceneParameters;
    using scene::SectionMesh;
    using Pair = std::pair<int, int>;

    Pair in_order(const int a, const int b)
    {
      return std::minmax(a, b);
    }



    class ContactLawBuilder
    {
    public:
      ContactLawBuilder(const SectionMesh           &section,
                        const SceneParameters       &parameters,
                        const BondLaws              &chosen_laws,
                        const std::vector<Material> &block_materials,
                        Model                       &block_model)
        : mesh(section)
        , scene(parameters)
        , bonds(chosen_laws)
        , material(section, parameters)
        , materials(block_materials)
        , model(block_model)
        , laws(block_model.contacts)
      {}

      void build()
      {
        name_edges_of_mass();
        name_bedrock_edges();
        name_segments();
        name_belts();
        for (const Surface &surface : surfaces)
          {
            laws.of.emplace_back();
            laws.of.back().reserve(model.n_blocks());
            for (int b = 0; b < model.n_blocks(); ++b)
              laws.of.back().push_back(law_of(b, surface));
          }
        for (const Joint &joint : model.joints)
          if (joint.kind == JointKind::body)
            laws.bonded.push_back(in_order(joint.block, joint.other));
        std::sort(laws.bonded.begin(), laws.bonded.end());
        laws.bonded.erase(std::unique(laws.bonded.begin(), laws.bonded.end()), laws.bonded.end());
      }

    private:
      /// Belts come last: where two surfaces meet, their contact is on the belt.
      enum class Kind
      {
        bedrock,
        mass,
        joint,
        belt
      };

      struct Surface
      {
        Kind            kind;
        const Material *made_of; ///< nullptr: the block's own
      };

      const SectionMesh           &mesh;
      const SceneParameters       &scene;
      const BondLaws              &bonds;
      const BlockMaterials         material;
      const std::vector<Material> &materials;
      Model                       &model;
      ContactLaws                 &laws;
      std::vector<Surface>         surfaces{{Kind::bedrock, nullptr}};

      int number_of(const Kind kind, const Material *made_of)
      {
        const auto found = std::find_if(surfaces.begin(), surfaces.end(), [&](const Surface &s) {
          return s.kind == kind && s.made_of == made_of;
        });
        if (found != surfaces.end())
          return static_cast<int>(found - surfaces.begin());
        surfaces.push_back({kind, made_of});
        return static_cast<int>(surfaces.size()) - 1;
      }

      int        bedrock_surface(const int region);
      void       name_edges_of_mass();
      void       name_bedrock_edges();
      void       name_segments();
      void       name_belts();
      ContactLaw law_of(int block, const Surface &surface) const;
    };



    /// Bedrock whose friction angle nobody has given has that of the block.
    int ContactLawBuilder::bedrock_surface(const int region)
    {
      const std::string &name = mesh.bedrock_region_names[region];
      if (scene.continuum.region_material.of(name).empty())
        return 0;
      const Material &rock = scene.bedrock_material(name);
      return rock.friction_is_given() ? number_of(Kind::bedrock, &rock) : 0;
    }



    void ContactLawBuilder::name_edges_of_mass()
    {
      const Geometry &g = model.initial;
      laws.edge.assign(g.vertices.size(), 0);
      for (int b = 0; b < model.n_mass(); ++b)
        {
          const BlockProperties &p = model.blocks[b];
          const int inner          = number_of(Kind::mass, &material.mass(p.region, p.saturated));
          const std::vector<int> &nodes = mesh.blocks[b];
          for (std::size_t k = 0; k < nodes.size(); ++k)
            {
              const int       v       = g.offset[b] + static_cast<int>(k);
              const Vec2      middle  = 0.5 * (g.vertices[v] + g.vertices[g.next(v)]);
              const Material *of_line = material.joint(nodes[k],
                                                       nodes[(k + 1) % nodes.size()],
                                                       material.below_water(middle));
              laws.edge[v] = of_line == nullptr ? inner : number_of(Kind::joint, of_line);
            }
        }
    }



    void ContactLawBuilder::name_bedrock_edges()
    {
      const Geometry &g             = model.initial;
      const int       n_mass_region = static_cast<int>(mesh.block_region_names.size());
      for (int b = model.n_mass(); b < g.n_blocks(); ++b)
        for (int v = g.offset[b]; v < g.offset[b + 1]; ++v)
          laws.edge[v] = bedrock_surface(model.blocks[b].region - n_mass_region);
    }



    /// The foundation runs along edges of the mesh, with nodes between their ends where elements
    /// are of higher degree.
    void ContactLawBuilder::name_segments()
    {
      const std::vector<Vec2> &nodes = model.initial.foundation_nodes;
      laws.segment.assign(nodes.empty() ? 0 : nodes.size() - 1, 0);
      std::map<Pair, int>                      region_at;
      std::map<std::pair<double, double>, int> node_at;
      for (std::size_t c = 0; c < mesh.bedrock_cells.size(); ++c)
        for (int k = 0; k < 4; ++k)
          {
            const int a = mesh.bedrock_cells[c][k], e = mesh.bedrock_cells[c][(k + 1) % 4];
            region_at[in_order(a, e)]                       = mesh.bedrock_region[c];
            node_at[{mesh.nodes[a].x(), mesh.nodes[a].y()}] = a;
          }
      int from = -1, first = 0;
      for (std::size_t k = 0; k < nodes.size(); ++k)
        {
          const auto found = node_at.find({nodes[k].x(), nodes[k].y()});
          if (found == node_at.end())
            continue;
          const auto edge = region_at.find(in_order(from, found->second));
          if (from >= 0 && edge != region_at.end())
            std::fill(laws.segment.begin() + first,
                      laws.segment.begin() + static_cast<int>(k),
                      bedrock_surface(edge->second));
          from  = found->second;
          first = static_cast<int>(k);
        }
    }



    void ContactLawBuilder::name_belts()
    {
      const Geometry &g = model.initial;
      for (const bool saturated : {false, true}) // numbers of their own, above all others
        if (!scene.blocks.belt_material.empty())
          number_of(Kind::belt, &material.belt(saturated));
      for (const Joint &joint : model.joints)
        {
          if (joint.kind != JointKind::belt)
            continue;
          const Vec2 a = g.vertices[joint.edge], e = g.vertices[g.next(joint.edge)];
          const Vec2 middle =
            a + 0.5 * (joint.points[0].position + joint.points[1].position) * (e - a);
          const int belt = number_of(Kind::belt, &material.belt(material.below_water(middle)));
          if (joint.other == foundation_body)
            laws.segment[joint.points[0].other_vertex] = belt;
          else
            laws.edge[joint.points[1].other_vertex] = belt;
        }
    }



    ContactLaw ContactLawBuilder::law_of(const int block, const Surface &surface) const
    {
      const BlockProperties &p       = model.blocks[block];
      const bool             bedrock = model.is_bedrock(block);
      const Material &own = bedrock ? materials[block] : material.mass(p.region, p.saturated);
      const double k_n = scene.blocks.penalty_ratio * own.young_modulus * p.modulus_factor / p.size;
      JointStrength strength = bonds.body.contact(own);
      if (surface.kind == Kind::belt)
        strength = bonds.belt.contact(*surface.made_of);
      else if (surface.kind == Kind::joint)
        strength = bonds.body.contact(*surface.made_of);
      else if (surface.made_of != nullptr)
        strength = strength.weaker_of(bonds.body.contact(*surface.made_of));
      if (surface.kind == Kind::bedrock)
        strength.cohesion = strength.residual_cohesion = 0.;
      return {JointLaw(strength, k_n, scene.blocks.shear_ratio * k_n), 0.5 * p.size};
    }
  } // namespace



  const ContactLaw &
  ContactLaws::law(const Geometry &initial, const Contact &contact, const int n_mass) const
  {
    const int  owner = contact.vertex_body, other = contact.edge_body;
    const auto is_mass = [n_mass](const int body) {
      return body != foundation_body && body < n_mass;
    };
    if (other == foundation_body)
      return of[segment[contact.edge]][owner];
    if (is_mass(owner))
      return of[edge[contact.edge]][owner];
    // A vertex of the ground lies between two of its edges.
    const int v = contact.vertex;
    if (owner != foundation_body)
      {
        const int before = edge_before(initial, owner, v);
        return of[std::max(edge[v], edge[before < 0 ? v : before])][other];
      }
    const int n = static_cast<int>(segment.size());
    return of[std::max(segment[std::max(0, v - 1)], segment[std::min(v, n - 1)])][other];
  }



  bool ContactLaws::were_bonded(const int block_, const int other) const
  {
    return std::binary_search(bonded.begin(), bonded.end(), in_order(block_, other));
  }



  void set_contact_laws(const SectionMesh           &mesh,
                        const SceneParameters       &scene,
                        const BondLaws              &laws,
                        const std::vector<Material> &materials,
                        Model                       &model)
  {
    ContactLawBuilder(mesh, scene, laws, materials, model).build();
  }
} // namespace hybrid::dda
