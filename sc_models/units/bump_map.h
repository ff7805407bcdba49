#pragma once
// Turns a scene's tangent-space normals (or normals made for one surface, surface_map.h) into the bump map that a scheme stores: each texel
// of each mip level is encoded on its own from the (normalised) Cartesian normal, so coarser levels are averages of vectors, never of
// angles. Preprocessing by the host: no hardware, no time. Source: schemes/scheme.h, BumpEncoding; filtering in Cartesian form, spec of
// each scheme.

#include "memory/texture.h"
#include "schemes/scheme.h"

namespace bump {

/// `normals` has three channels; wrap modes and levels are kept. Texels are not rounded; bytes_per_texel is that of the channel formats.
Texture encode_bump_map(const Texture& normals, const BumpEncoding& encoding);
/// The same map with every channel rounded to its format, as memory holds it.
Texture quantise_texels(Texture map, const BumpEncoding& encoding);
/// Channel widths together, rounded up to a power of two of bytes.
int bytes_per_texel(const BumpEncoding& encoding);

}  // namespace bump
