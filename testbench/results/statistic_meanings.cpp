#include "testbench/results/statistics_table.h"

namespace bump {

std::vector<StatisticMeaning> result_statistic_meanings() {
  return {
      {"run", "fragments", "fragments", "fragments that were shaded and arrived in the frame", ""},
      {"run", "fragments_per_cycle", "fragments/cycle", "throughput over the whole run, filling and draining included",
       "fragments / cycles"},
      {"run", "bound_cycles", "cycles", "fewest cycles that the busiest module or memory alone needs", "see bound.by"},
      {"run", "clock", "MHz", "configured clock", ""},
      {"run", "frames_per_second", "frames/s", "frames like this one in a second, one after another", "clock * 10^6 / cycles"},
      {"run", "interpolator_components", "components", "scalars interpolated for each fragment besides u and v", ""},

      {"operators", "built_multipliers", "operators", "multipliers of the published design, before sharing", ""},
      {"operators", "built_adders", "operators", "adders and subtractors of the published design", ""},
      {"operators", "built_dividers", "operators", "dividers of the published design", ""},
      {"operators", "built_square_roots", "operators", "square roots of the published design", ""},
      {"operators", "built_tables", "operators", "tables with one index; several outputs of one index are one table", ""},
      {"operators", "built_maps", "operators", "large tables with more than one index", ""},
      {"operators", "built_table_bits", "bits", "ROM bits, one copy for every read", ""},
      {"operators", "additional_multipliers", "operators", "multipliers that the design needs beside the published count", ""},
      {"operators", "additional_adders", "operators", "adders that the design needs beside the published count", ""},
      {"operators", "additional_dividers", "operators", "dividers that the design needs beside the published count", ""},
      {"operators", "additional_square_roots", "operators", "square roots that the design needs beside the published count", ""},
      {"operators", "additional_tables", "operators", "tables that the design needs beside the published count", ""},
      {"operators", "additional_maps", "operators", "maps that the design needs beside the published count", ""},
      {"operators", "additional_table_bits", "bits", "ROM bits of the additional tables and maps", ""},
      {"operators", "executions", "executions", "times the datapath was executed",
       "fragments * lights (fragments with light maps); fragments (colour, interpolators); vertices (vertex work); entries * lights * "
       "objects (frame)"},
      {"operators", "latency", "cycles", "from operands to result, by the schedule", ""},
      {"operators", "initiation_interval", "cycles", "between the starts of two executions",
       "ceil(multipliers / multipliers after sharing)"},
      {"operators", "multipliers_after_sharing", "operators", "multipliers in hardware after time-sharing", ""},

      {"table", "entries", "words", "words of the ROM", ""},
      {"table", "bits", "bits", "size of one copy", ""},
      {"table", "copies", "copies", "ROMs read in parallel, and one for each material where contents follow the material", ""},
      {"table", "reads", "reads", "look-ups in the whole run", ""},

      {"texture", "reads", "texels", "texels fetched for filtering", ""},
      {"texture", "accesses", "lines", "cache lines looked up", ""},
      {"texture", "hits", "lines", "cache lines found", ""},
      {"texture", "misses", "lines", "cache lines asked from memory", "accesses - hits"},
      {"texture", "hit_rate", "1", "share of look-ups that hit", "hits / accesses"},
      {"texture", "bytes", "bytes", "moved from memory", "misses * line bytes"},

      {"light_map", "entries", "words", "words of one object's map", ""},
      {"light_map", "bits", "bits", "size of the maps of all objects", "entries * width * objects"},
      {"light_map", "words_written", "words", "filled each frame, by the host or a frame before: no cycles of the pixel pipeline",
       "entries * objects"},
      {"light_map", "bytes_written", "bytes", "what filling moves to memory", "words_written * bytes of a word"},
      {"light_map", "reads", "words", "words fetched, each one look-up of the light-map cache", "fragments"},
      {"light_map", "hits", "words", "reads whose line was in the light-map cache", ""},
      {"light_map", "misses", "words", "reads whose line was asked from the light maps' memory", "reads - hits"},
      {"light_map", "hit_rate", "1", "share of reads that hit", "hits / reads"},
      {"light_map", "bytes", "bytes", "moved from the light maps' memory", "misses * line bytes"},
      {"light_map", "clipped", "words", "reads of words that the map's format had cut off: the lights' sum was too bright for it", ""},

      {"geometry", "vertices", "vertices", "vertices transformed", ""},
      {"geometry", "vertex_reuses", "vertices", "vertices found in the post-transform cache", ""},
      {"geometry", "triangles", "triangles", "triangles that entered", ""},
      {"geometry", "triangles_clipped", "triangles", "triangles cut by the near plane or the guard band", ""},
      {"geometry", "triangles_culled", "triangles", "triangles dropped for facing away", ""},
      {"geometry", "triangles_empty", "triangles", "triangles beside the frame, edge-on, or covering no pixel centre", ""},
      {"geometry", "triangles_hidden", "triangles", "triangles that cover pixel centres, all killed by early z", ""},
      {"geometry", "triangles_drawn", "triangles", "triangles with at least one fragment",
       "triangles - triangles_culled - triangles_empty - triangles_hidden"},
      {"geometry", "fragments_generated", "fragments", "pixel centres covered", ""},
      {"geometry", "fragments_hidden", "fragments", "killed by early z", ""},
      {"geometry", "fragments", "fragments", "sent on to be shaded", "fragments_generated - fragments_hidden"},
      {"geometry", "fragments_retired", "fragments", "arrived in the frame sink", ""},

      {"quality", "psnr_db", "dB", "signal-to-noise ratio over object pixels, channels pooled; inf for identical images",
       "10 log10(1 / mean (reference - test)^2)"},
      {"quality", "nmse_*", "1", "normalised mean squared error of a channel", "sum (reference - test)^2 / sum reference^2"},
      {"quality", "rnmse_*", "1", "its root", "sqrt(nmse)"},
      {"quality", "pmse_*", "1", "mean squared error of a channel against the peak 1", "mean (reference - test)^2"},
      {"quality", "rpmse_*", "1", "its root", "sqrt(pmse)"},
      {"quality", "max_error", "1/255", "largest difference of a channel, in 8-bit steps", "255 max |reference - test|"},
      {"quality", "mean_error", "1/255", "mean difference of the channels, in 8-bit steps", "255 mean |reference - test|"},
      {"quality", "pixels", "pixels", "pixels that show the same surface in both images", ""},
      {"quality", "excluded", "pixels", "pixels with an object in either image, but not the same surface in both", ""},

      {"angular_error", "count", "vectors", "vectors compared, of all fragments and lights those that light the surface: exact z > 0", ""},
      {"angular_error", "mean_degrees", "degrees", "mean angle between the delivered and the exact vector; none if no vector counts", ""},
      {"angular_error", "rms_degrees", "degrees", "root of the mean squared angle", ""},
      {"angular_error", "max_degrees", "degrees", "largest angle", ""},
  };
}

}  // namespace bump
