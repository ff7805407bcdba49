# The sources that models_digest() covers, sorted: everything that can change a figure of a run or of a row of a sweep. A project that is
# configured says CONFIGURE_DEPENDS, so that new files count; a script cannot.
function(bump_digested_sources result root)
  file(GLOB_RECURSE models ${ARGN} ${root}/sc_models/*.h ${root}/sc_models/*.cpp)
  list(FILTER models EXCLUDE REGEX "/test_[^/]*\\.cpp$|/sc_models/rtl/")
  file(GLOB others ${ARGN} ${root}/testbench/scene/*.h ${root}/testbench/scene/*.cpp ${root}/testbench/images/*.h ${root}/testbench/images/*.cpp
       ${root}/testbench/reference/*.h ${root}/testbench/reference/*.cpp ${root}/testbench/results/*.h ${root}/testbench/results/*.cpp
       ${root}/testbench/experiments/measured_run.* ${root}/testbench/experiments/tangent_fit.* ${root}/testbench/experiments/compare_metrics.*
       ${root}/testbench/experiments/retime.* ${root}/testbench/experiments/retime_traffic.* ${root}/testbench/experiments/sweep_columns.*
       ${root}/testbench/experiments/sweep_work.*)
  set(all ${models} ${others})
  list(SORT all)
  set(${result} ${all} PARENT_SCOPE)
endfunction()
