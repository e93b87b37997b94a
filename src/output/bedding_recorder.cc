// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/bedding_recorder.h>

#include <algorithm>
#include <cmath>

namespace hybrid::output
{
  BeddingRecorder::BeddingRecorder(const continuum::Continuum     *bedrock,
                                   const dda::Model               *blocks,
                                   const std::vector<std::string> &names)
    : continuum(bedrock)
  {
    if (continuum != nullptr)
      for (const continuum::BeddingPlane &plane : continuum->slipping_planes())
        planes.push_back({plane.name, plane.points, {}});
    else if (blocks != nullptr && blocks->n_bedrock > 0)
      add_block_planes(*blocks, names);
  }



  void BeddingRecorder::add_block_planes(const dda::Model               &blocks,
                                         const std::vector<std::string> &names)
  {
    for (const std::string &name : names)
      planes.push_back({name, {}, {}});
    const dda::Geometry &g = blocks.initial;
    for (std::size_t j = 0; j < blocks.joints.size(); ++j)
      {
        const dda::Joint &joint = blocks.joints[j];
        if (joint.kind != dda::JointKind::bedding)
          continue;
        Plane &plane = planes[joint.plane];
        plane.joints.push_back(static_cast<int>(j));
        plane.points.insert(plane.points.end(),
                            {g.vertices[joint.edge], g.vertices[g.next(joint.edge)]});
      }
    planes.erase(std::remove_if(planes.begin(),
                                planes.end(),
                                [](const Plane &plane) { return plane.joints.empty(); }),
                 planes.end());
  }



  void BeddingRecorder::add_series(HistoryFile &file)
  {
    for (Plane &plane : planes)
      {
        std::vector<double> position;
        for (const Vec2 &point : plane.points)
          position.insert(position.end(), {point.x(), point.y()});
        const std::size_t n    = plane.points.size();
        const std::string path = "bedding/" + plane.name + "/";
        file.write_table(path + "position", "m", position.data(), n, 2, "points of the plane");
        plane.slip          = file.add_series(path + "slip", "m", n, "of the upper side along +x");
        plane.opening       = file.add_series(path + "opening", "m", n, "plastic part");
        plane.normal_stress = file.add_series(path + "normal_stress",
                                              "Pa",
                                              n,
                                              "compression positive, with that at rest");
        plane.shear_stress  = file.add_series(path + "shear_stress", "Pa", n, "with that at rest");
        plane.condition =
          file.add_series(path + "condition", "1", n, "0 elastic, 1 slipping, 2 open");
      }
    if (!planes.empty())
      time = file.add_series("bedding/time", "s", 1, "times of the audits");
  }



  continuum::BeddingValues BeddingRecorder::values(const coupling::CoupledState &state,
                                                   const std::size_t             plane) const
  {
    if (continuum != nullptr)
      return continuum->bedding_values(state.continuum, continuum->slipping_planes()[plane]);
    using Condition = continuum::PlaneCondition;
    continuum::BeddingValues values;
    for (const int joint : planes[plane].joints)
      for (const dda::SpringState &point : state.blocks.joints[joint].points)
        {
          // The joint counts the other side's slip along the outline of its block: seen along +x,
          // the upper side's slip is the opposite, whichever of the two the block is.
          const bool open = point.state == dda::ContactState::open;
          values.slip.push_back(-point.history.plastic_slip);
          values.opening.push_back(open ? std::max(0., point.gap) : 0.);
          values.normal_stress.push_back(point.normal);
          values.shear_stress.push_back(point.shear);
          values.condition.push_back(static_cast<double>(open ? Condition::open
                                                         : point.state == dda::ContactState::sliding
                                                           ? Condition::slipping
                                                           : Condition::elastic));
        }
    return values;
  }



  void BeddingRecorder::summarize(const coupling::CoupledState &state, Summary &summary) const
  {
    for (std::size_t k = 0; k < planes.size(); ++k)
      {
        const continuum::BeddingValues now  = values(state, k);
        Summary::PlaneSlip            &slip = summary.planes[planes[k].name];
        for (std::size_t i = 0; i < now.slip.size(); ++i)
          {
            slip.opening_left = std::max(slip.opening_left, now.opening[i]);
            if (i > 0 && !(std::abs(now.slip[i]) > std::abs(slip.largest_left)))
              continue;
            slip.largest_left = now.slip[i];
            slip.where        = {{planes[k].points[i].x(), planes[k].points[i].y()}};
          }
      }
  }



  void BeddingRecorder::record(const coupling::CoupledState &state, HistoryFile &file) const
  {
    if (planes.empty())
      return;
    const double t = state.time;
    file.append(time, &t);
    for (std::size_t k = 0; k < planes.size(); ++k)
      {
        const continuum::BeddingValues now = values(state, k);
        file.append(planes[k].slip, now.slip.data());
        file.append(planes[k].opening, now.opening.data());
        file.append(planes[k].normal_stress, now.normal_stress.data());
        file.append(planes[k].shear_stress, now.shear_stress.data());
        file.append(planes[k].condition, now.condition.data());
      }
  }
} // namespace hybrid::output
