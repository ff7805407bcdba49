#pragma once
// The arithmetic of the rasterizer over neighbouring fragments, in loops that vectorise: weights and depth along a row, then perspective
// and derivatives of the texture coordinates. Every fragment's value is the one that it has by itself. Part of the rasterizer's time.
// Source: Heckbert and Moreton, "Interpolation for polygon texture mapping and shading", 1991.

namespace bump {

/// Edge functions 1 and 2 at the first pixel and from pixel to pixel, whole numbers below 2^51; the reciprocal of the area; depth at corner
/// 0, and how much more it is at corners 1 and 2.
struct RowStart {
  double edge1, edge2, across1, across2, scale, depth0, depth1, depth2;
};

/// Screen-space weights and depths of `count` neighbours. Returns how many of them lie in front of what is stored.
int weigh_row(const RowStart& row, int count, const double* stored, double* weight1, double* weight2, double* depth);

/// What perspective makes of the weights of a raster triangle: b1x is the change of weight 1 from pixel to pixel, b1y from row to row, q
/// are the 1 / w of the corners, u0 and v0 texture coordinates of corner 0, and u1 ... v2 the differences from them.
struct Perspective {
  double b1x, b2x, b1y, b2y, q0, q1, q2, u0, u1, u2, v0, v1, v2;
};

/// `count` fragments of one triangle: weights become perspective-correct in place. No two planes overlap.
void interpolate_lanes(const Perspective& triangle, int count, double* weight1, double* weight2, double* u, double* v, double* dudx,
                       double* dvdx, double* dudy, double* dvdy);

}  // namespace bump
