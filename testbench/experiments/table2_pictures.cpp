#include "testbench/experiments/table2_pictures.h"

#include "testbench/experiments/table2_formats.h"
#include "testbench/results/image_file.h"
#include "testbench/results/pending_folder.h"

namespace bump {

namespace {

constexpr FolderKind pictures_kind = {"set of pictures of table2",
                                      "bumpsim-table2",
                                      {"table2.json",
                                       "plane-conventional.png",
                                       "plane-blinn.png",
                                       "plane-object-kim.png",
                                       "plane-object-proposed.png",
                                       "plane-object-error.png",
                                       "plane-eye-kim.png",
                                       "plane-eye-proposed.png",
                                       "plane-eye-error.png",
                                       "cube-conventional.png",
                                       "cube-blinn.png",
                                       "cube-object-kim.png",
                                       "cube-object-proposed.png",
                                       "cube-object-error.png",
                                       "cube-eye-kim.png",
                                       "cube-eye-proposed.png",
                                       "cube-eye-error.png",
                                       "sphere-conventional.png",
                                       "sphere-blinn.png",
                                       "sphere-object-kim.png",
                                       "sphere-object-proposed.png",
                                       "sphere-object-error.png",
                                       "sphere-eye-kim.png",
                                       "sphere-eye-proposed.png",
                                       "sphere-eye-error.png"}};

/// The folder's rules are those of results, whose texts name --out.
template <class Work>
void as_pictures(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    ErrorText text = error.text();
    const std::size_t option = text.try_this.find("--out");
    if (option != std::string::npos) text.try_this.replace(option, 5, "--pictures");
    throw Error(error.kind(), text);
  }
}

}  // namespace

void check_table2_pictures(const std::string& folder, bool force) {
  as_pictures([&] { check_output_folder(folder, force, pictures_kind); });
}

void write_table2_pictures(const std::string& folder, const Table2& table, const Configuration& configuration, bool force) {
  as_pictures([&] {
    PendingFolder pending(folder, force, pictures_kind);
    for (const Table2Picture& picture : table.pictures) {
      const std::string prefix = picture.scene + "-" + (picture.space ? name_of(*picture.space) + "-" : "");
      pending.write(prefix + picture.method + ".png", encode_png(picture.frame));
      const Table2Picture* reference = table.picture(picture.scene, "conventional", std::nullopt);
      if (picture.method == "proposed" && reference != nullptr)
        pending.write(prefix + "error.png", encode_png(error_image(picture.frame, reference->frame)));
    }
    pending.write("table2.json", table2_json(table, configuration).dump(2) + "\n");  // last: without it the folder is no set of pictures
    pending.commit();
  });
}

}  // namespace bump
