#include "testbench/scene/only_material.h"

#include "datapath/error.h"

namespace bump {

const Material& only_material(const Scene& scene) {
  if (scene.objects.empty()) throw Error({"the scene has no object", {}, "no fragment would reach the units", ""});
  const Material& material = scene.objects.front().material;
  for (const SceneObject& object : scene.objects)
    if (!(object.material == material))
      throw Error(
          {"the objects of the scene are of several materials", {}, "an emitted unit holds the tables of one", "one material for all"});
  return material;
}

}  // namespace bump
