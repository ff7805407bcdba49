#pragma once
// The maps of Peercy, Airey and Cabral 1997 that are made for one surface: N' in object space (section 2.1), and N' from the surface's own
// derivatives (Eqs 3-6), in either space. Preprocessing by the host, once for an object: no hardware, no time. Maps in tangent space under
// the square-patch assumption (Eqs 8-11, k one texel) need none of this: they are the normals that the scene delivers.

#include "units/surface_map.h"

namespace bump::peercy1997 {

enum class MapSpace { tangent, object };
enum class Perturbation {
  square_patch,  ///< Eqs 8-11: the scene's own tangent-space normals
  surface        ///< Eqs 3-6: from the heights, with Pu and Pv of the mesh
};

/// The bump map of an object. Throws Error(input) if Perturbation::surface finds a normal map without heights, or if the object's texture
/// coordinates admit no such map (units/texture_chart.h).
SurfaceMap surface_map(const SceneObject& object, MapSpace space, Perturbation perturbation);

}  // namespace bump::peercy1997
