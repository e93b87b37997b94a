// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/geometry/cell_grid.h>
#include <hybrid/dda/geometry/polygon.h>
#include <hybrid/dda/model/downhill.h>
#include <hybrid/dda/model/model.h>
#include <hybrid/scene/mesh/downhill.h>

#include <algorithm>
#include <numeric>

namespace hybrid::dda
{
  namespace
  {
    constexpr double touching_distance =
      0.05; ///< of blocks that touch, over the smaller one's size [-]



    /// Boxes around the blocks of the mass, with room for what touches them.
    std::vector<Box> boxes_of_mass(const Model &model)
    {
      const Geometry  &g = model.initial;
      std::vector<Box> boxes;
      for (int b = 0; b < model.n_mass(); ++b)
        {
          const auto begin = g.vertices.begin() + g.offset[b],
                     end   = g.vertices.begin() + g.offset[b + 1];
          Box box{*begin, *begin};
          for (auto v = begin; v != end; ++v)
            box = {box.lower.cwiseMin(*v), box.upper.cwiseMax(*v)};
          const Vec2 room = Vec2::Constant(touching_distance * model.blocks[b].size);
          boxes.push_back({box.lower - room, box.upper + room});
        }
      return boxes;
    }



    /// The vertex lies on the block, or beside it.
    bool is_at_block(const Model &model, const int vertex, const int block)
    {
      const Geometry &g       = model.initial;
      const Vec2     &x       = g.vertices[vertex];
      const Vec2     *outline = &g.vertices[g.offset[block]];
      const int       n       = g.offset[block + 1] - g.offset[block];
      const double size = std::min(model.blocks[block].size, model.blocks[g.block_of[vertex]].size);
      return distance_to_outline(outline, n, x) <= touching_distance * size ||
             contains(outline, n, x);
    }



    /// The first block of each block's slide, where @p first is that of some of its blocks.
    int root_of(std::vector<int> &first, const int block)
    {
      int root = block;
      while (first[root] != root)
        root = first[root] = first[first[root]];
      return root;
    }



    /// Per block of the mass: number of the slide, in the order of their first blocks.
    std::vector<int> find_slides(const Model &model)
    {
      std::vector<int> first(model.n_mass());
      std::iota(first.begin(), first.end(), 0);
      CellGrid grid;
      grid.build(boxes_of_mass(model));
      std::vector<int> found;
      for (int v = 0; v < model.initial.offset[model.n_mass()]; ++v)
        {
          found.clear();
          grid.find(model.initial.vertices[v], found);
          for (const int other : found)
            {
              const int a = root_of(first, model.initial.block_of[v]), b = root_of(first, other);
              if (a != b && is_at_block(model, v, other))
                first[std::max(a, b)] = std::min(a, b);
            }
        }
      std::vector<int> slide(model.n_mass());
      int              count = 0;
      for (int b = 0; b < model.n_mass(); ++b)
        {
          const int root = root_of(first, b);
          slide[b]       = root == b ? count++ : slide[root];
        }
      return slide;
    }



    /// Sign of x downhill of a slide. @param covered ends of its soles on the ground, perhaps none
    double sign_of_slide(const std::vector<Vec2>  &covered,
                         const std::vector<Vec2>  &corners,
                         const scene::SectionMesh &mesh)
    {
      if (covered.empty())
        return 0.;
      const scene::LineEnds stretch = scene::ends_of(covered, scene::WallEnd::foot),
                            whole   = scene::ends_of(corners, scene::WallEnd::foot);
      if (const double sign = stretch.downhill(); sign != 0.)
        return sign;
      if (const double sign = scene::downhill_beside(stretch, mesh); sign != 0.)
        return sign;
      return scene::downhill_above(whole.left.x(), whole.right.x(), mesh);
    }



    /// Sign of each slide by what it lies on; 0 where that says nothing.
    std::vector<double> signs_of_slides(const Model              &model,
                                        const scene::SectionMesh &mesh,
                                        const std::vector<int>   &slide)
    {
      const Geometry                &g        = model.initial;
      const int                      n_slides = 1 + *std::max_element(slide.begin(), slide.end());
      std::vector<std::vector<Vec2>> covered(n_slides), corners(n_slides);
      for (const Sole &sole : model.soles)
        for (const Vec2 &end : sole.below)
          covered[slide[g.block_of[sole.first]]].push_back(end);
      for (int v = 0; v < g.offset[model.n_mass()]; ++v)
        corners[slide[g.block_of[v]]].push_back(g.vertices[v]);
      std::vector<double> sign;
      for (int k = 0; k < n_slides; ++k)
        sign.push_back(sign_of_slide(covered[k], corners[k], mesh));
      return sign;
    }



    /// The one sign among these, 0 if there is none, or both.
    double shared_sign(const std::vector<double> &signs)
    {
      const bool left  = std::count(signs.begin(), signs.end(), -1.) > 0,
                 right = std::count(signs.begin(), signs.end(), 1.) > 0;
      return left == right ? 0. : right ? 1. : -1.;
    }
  } // namespace



  double Downhill::shared() const
  {
    return shared_sign(sign);
  }



  bool Downhill::is_level() const
  {
    return std::all_of(sign.begin(), sign.end(), [](const double s) { return s == 0.; });
  }



  Downhill find_downhill(const Model &model, const scene::SectionMesh &mesh)
  {
    Downhill downhill;
    if (model.n_mass() == 0)
      return downhill;
    downhill.slide                 = find_slides(model);
    const std::vector<double> sign = signs_of_slides(model, mesh, downhill.slide);
    const double              all  = shared_sign(sign);
    for (const int slide : downhill.slide)
      downhill.sign.push_back(sign[slide] != 0. ? sign[slide] : all);
    return downhill;
  }
} // namespace hybrid::dda
