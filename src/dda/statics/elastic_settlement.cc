// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/statics/elastic_settlement.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace hybrid::dda
{
  namespace
  {
    /// Blocks in bodies: each body is known by one of its blocks.
    class Bodies
    {
    public:
      explicit Bodies(const int n_blocks)
        : next(n_blocks)
      {
        std::iota(next.begin(), next.end(), 0);
      }

      /// The block by which the body of a block is known.
      int of(int block)
      {
        while (next[block] != block)
          block = next[block] = next[next[block]];
        return block;
      }

      /// Two blocks are in one body; nothing where one of them is not in the mass.
      void connect(const int a, const int b)
      {
        const int n = static_cast<int>(next.size());
        if (a >= 0 && b >= 0 && a < n && b < n)
          next[of(a)] = of(b);
      }

    private:
      std::vector<int> next; ///< towards the block that stands for the body
    };


    struct Body
    {
      double lowest  = std::numeric_limits<double>::infinity();
      double highest = -std::numeric_limits<double>::infinity(); ///< of its corners as drawn [m]
      double strain  = 0.;                                       ///< rho g / G of its softest [1/m]
    };
  } // namespace



  std::vector<double> elastic_settlement(const Model &model, const DdaState &rest)
  {
    static_assert(foundation_body < 0, "the foundation is no block");
    const int n = model.n_mass();
    Bodies    bodies(n);
    for (const Joint &joint : model.joints)
      bodies.connect(joint.block, joint.other);
    for (const Contact &contact : rest.contacts)
      if (contact.state != ContactState::open)
        bodies.connect(contact.vertex_body, contact.edge_body);

    std::vector<Body> found(n);
    for (int b = 0; b < n; ++b)
      {
        const BlockProperties &p    = model.blocks[b];
        Body                  &body = found[bodies.of(b)];
        body.strain =
          std::max(body.strain, p.weight * model.gravity / (p.area * p.elasticity(2, 2)));
        for (int v = model.initial.offset[b]; v < model.initial.offset[b + 1]; ++v)
          {
            body.lowest  = std::min(body.lowest, model.initial.vertices[v].y());
            body.highest = std::max(body.highest, model.initial.vertices[v].y());
          }
      }
    std::vector<double> settlement(n);
    for (int b = 0; b < n; ++b)
      {
        const Body  &body   = found[bodies.of(b)];
        const double height = body.highest - body.lowest;
        settlement[b]       = body.strain * height * height;
      }
    return settlement;
  }



  double work_of_settlement(const Model &model, const DdaState &rest)
  {
    const std::vector<double> settlement = elastic_settlement(model, rest);
    double                    work       = 0.;
    for (int b = 0; b < model.n_mass(); ++b)
      work += model.blocks[b].weight * model.gravity * settlement[b];
    return work;
  }
} // namespace hybrid::dda
