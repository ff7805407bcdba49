#pragma once
// From pictures to the textures of a scene: colours, heights in texels, and unit tangent-space normals, with all mip levels. The bump map
// of every scheme is made from these normals. Heights become normals by central differences (Cg Tutorial ch. 8 takes forward ones, which
// shift the relief by half a texel). Levels of normals are averaged and made unit again; levels of heights and colours are averaged.

#include <memory>
#include <string>
#include <vector>

#include "memory/texture.h"
#include "testbench/scene/file_name.h"
#include "testbench/scene/image.h"

namespace bump {

struct Wrap {
  WrapMode u = WrapMode::repeat, v = WrapMode::repeat;
};

/// Who names a map: what a scene can mend with a key, a material library cannot.
enum class NamedBy { scene, material_library };

// `name`: errors give its path; warnings and the texture give the name it is shown under.

/// Three channels in [0, 1]; grey is repeated. Values outside are clamped with a warning. 4 bytes a texel (8 of deeper pictures).
Texture colour_texture(const Image& image, const FileName& name, const Wrap& wrap, std::vector<std::string>& warnings);
/// One texel of one colour.
Texture constant_colour(double red, double green, double blue);

/// One channel: the stored value times `scale`, in texels of level 0. Of a colour picture the mean of its channels is taken, with a
/// warning. Throws Error(input) at `from` if it looks like a normal map.
Texture height_texture(const Image& image, const FileName& name, double scale, const Wrap& wrap, const Location& from,
                       std::vector<std::string>& warnings);

/// n = normalize(-dh/dx, -dh/dy, 1), x along u, y along v, central differences with the texture's wrap modes (at a clamped border the
/// relief goes on level).
Texture normals_from_heights(const Texture& heights);

/// n = 2c - 1, made unit. `green_down`: the map's green points along falling v (DirectX's habit). Warns when the mean length is more than 1
/// % off or scatters by more than 1 % (with both measured), when texels point inwards (kept), have no length (they become flat), or when
/// the slopes contradict the green direction. Throws Error(input) at `from` if the picture is grey.
Texture normals_from_map(const Image& image, const FileName& name, bool green_down, const Wrap& wrap, const Location& from,
                         std::vector<std::string>& warnings, NamedBy named_by = NamedBy::scene);

/// A flat map: one texel, +z.
Texture flat_normals();

/// A built-in relief for meshes that come without one: 8 x 8 rounded studs, 6 texels high, on 256 x 256 texels; tiles.
Texture stud_heights();

/// Correlation of the mixed slope derivatives d(nx/nz)/dy and d(ny/nz)/dx over level 0, in [-1, 1]. A relief has both equal (they are the
/// mixed second derivative of its height), so that a clearly negative value betrays a green channel of the wrong sign. 0 if the map is
/// flat.
double integrability(const Texture& normals);

/// Correlation of ny with -dh/dy, in [-1, 1]: negative if the green channel and the heights contradict each other. 0 if either is flat.
/// The sizes must be equal.
double green_correlation(const Texture& normals, const Texture& heights);

}  // namespace bump
