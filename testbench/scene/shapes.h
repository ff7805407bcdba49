#pragma once
// Analytic shapes with exact tangent frames at every vertex. All have z as their axis, counter-clockwise triangles seen from outside,
// handedness +1, and positions that are bit-equal along seams, so that no crack opens. The default tessellations keep interpolated vectors
// within 50 dB of exact ones. Source of the torus: Cg Tutorial ch. 8, Eq 8-3 to 8-6.

#include "units/scene.h"

namespace bump {

/// The rectangle [-width/2, width/2] x [-height/2, height/2] in the xy plane, normal +z, u along +x, v along +y, both 0 to 1.
Mesh make_plane(double width, double height, int columns, int rows);

/// A cube of edge `size` about the origin; every face has the texture once, upright (v along +z on the sides, along +y on top and bottom).
Mesh make_cube(double size, int segments);

/// Latitude and longitude: poles on z, u = longitude / 360 degrees growing eastwards from +x, v from the south pole (0) to the north pole
/// (1). Tangent e_phi, binormal northwards. At the poles every column of triangles has its own vertex, whose frame belongs to the column's
/// middle.
Mesh make_sphere(double radius, int segments, int rings);

/// P = ((M + N cos 2 pi t) cos 2 pi s, (M + N cos 2 pi t) sin 2 pi s, N sin 2 pi t) with M = radius, N = tube; u = s, v = t.
/// The tutorial repeats the texture by (-6, 2), which runs u against its tangent dP/ds; scale_texture(mesh, 6, 2) keeps them together.
Mesh make_torus(double radius, double tube, int segments, int rings);

/// Multiplies all texture coordinates; a negative factor mirrors, and the frames follow (tangent along growing u, handedness).
void scale_texture(Mesh& mesh, double u, double v);

}  // namespace bump
