#include "units/raster_lanes.h"

#include "datapath/lane_clones.h"

namespace bump {

BUMP_LANE_LOOP int weigh_row(const RowStart& r, int count, const double* __restrict stored, double* __restrict weight1,
                             double* __restrict weight2, double* __restrict depth) {
  const double edge1 = r.edge1, edge2 = r.edge2, across1 = r.across1, across2 = r.across2, scale = r.scale;
  const double depth0 = r.depth0, depth1 = r.depth1, depth2 = r.depth2;
  int visible = 0;
  for (int i = 0; i < count; ++i) {
    const double w1 = (edge1 + i * across1) * scale, w2 = (edge2 + i * across2) * scale;
    const double z = depth0 + w1 * depth1 + w2 * depth2;
    weight1[i] = w1;
    weight2[i] = w2;
    depth[i] = z;
    visible += z < stored[i] ? 1 : 0;
  }
  return visible;
}

BUMP_LANE_LOOP void interpolate_lanes(const Perspective& t, int count, double* __restrict weight1, double* __restrict weight2,
                                      double* __restrict u, double* __restrict v, double* __restrict dudx, double* __restrict dvdx,
                                      double* __restrict dudy, double* __restrict dvdy) {
  const double b1x = t.b1x, b2x = t.b2x, b1y = t.b1y, b2y = t.b2y, q0 = t.q0, q1 = t.q1, q2 = t.q2;
  const double u0 = t.u0, u1 = t.u1, u2 = t.u2, v0 = t.v0, v1 = t.v1, v2 = t.v2;
  const double dqx = b1x * (q1 - q0) + b2x * (q2 - q0), dqy = b1y * (q1 - q0) + b2y * (q2 - q0);
  for (int i = 0; i < count; ++i) {
    const double b1 = weight1[i], b2 = weight2[i];
    const double w = 1 / (q0 + b1 * (q1 - q0) + b2 * (q2 - q0));
    const double w1 = b1 * q1 * w, w2 = b2 * q2 * w;
    // Quotient rule: the weights are b_i q_i over the interpolated 1 / w.
    const double w1x = (b1x * q1 - w1 * dqx) * w, w2x = (b2x * q2 - w2 * dqx) * w;
    const double w1y = (b1y * q1 - w1 * dqy) * w, w2y = (b2y * q2 - w2 * dqy) * w;
    weight1[i] = w1;
    weight2[i] = w2;
    u[i] = u0 + w1 * u1 + w2 * u2;
    v[i] = v0 + w1 * v1 + w2 * v2;
    dudx[i] = w1x * u1 + w2x * u2;
    dvdx[i] = w1x * v1 + w2x * v2;
    dudy[i] = w1y * u1 + w2y * u2;
    dvdy[i] = w1y * v1 + w2y * v2;
  }
}

}  // namespace bump
