# Writes OUTPUT, a C++ file that defines models_digest(): a hash over the names and contents of the sources from which results come.
# Called when one of them has changed: cmake -DROOT=... -DOUTPUT=... -P source_digest.cmake
include(${CMAKE_CURRENT_LIST_DIR}/digested_sources.cmake)
bump_digested_sources(sources ${ROOT})
set(text "")
foreach(source ${sources})
  file(SHA256 ${source} hash)
  file(RELATIVE_PATH name ${ROOT} ${source})
  string(APPEND text "${name} ${hash}\n")
endforeach()
string(SHA256 digest "${text}")
string(SUBSTRING ${digest} 0 16 digest)
file(WRITE ${OUTPUT} "#include \"testbench/program/version.h\"\n\nnamespace bump {\n\nstd::string models_digest() { return \"${digest}\"; }\n\n}  // namespace bump\n")
