#include <sys/resource.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "datapath/error.h"
#include "datapath/sha256.h"
#include "luts/rom_image.h"
#include "luts/write_roms.h"
#include "random_netlist.h"

using namespace bump;
using namespace bump_test;

namespace {

/// A folder of its own that goes away with the test.
class Folder {
 public:
  Folder() : path_(std::filesystem::temp_directory_path() / ("bump_roms_" + std::to_string(getpid()))) {
    std::filesystem::remove_all(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string name() const { return (path_ / "roms").string(); }
  std::string file(const std::string& file) const { return (path_ / "roms" / file).string(); }

 private:
  std::filesystem::path path_;
};

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Words of the columns that have bits of their own, as $readmemh and a part select would give them.
std::vector<std::vector<std::int64_t>> parse(const std::string& image, const Table& table) {
  std::vector<std::vector<std::int64_t>> words(table.columns.size());
  std::istringstream lines(image);
  for (std::string line; std::getline(lines, line);) {
    std::string bits;
    for (const char digit : line)
      for (int bit = 3; bit >= 0; --bit) bits += ((std::stoi(std::string(1, digit), nullptr, 16) >> bit) & 1) != 0 ? '1' : '0';
    std::size_t width = 0;
    for (const Column& column : table.columns)
      if (!column.mirrors_first) width += static_cast<std::size_t>(table.stored_width(column));
    bits = bits.substr(bits.size() - width);
    std::size_t at = 0;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      const Column& column = table.columns[i];
      if (column.mirrors_first) continue;
      const auto size = static_cast<std::size_t>(table.stored_width(column));
      std::int64_t word = 0;
      for (const char bit : bits.substr(at, size)) word = 2 * word + (bit == '1' ? 1 : 0);
      const bool keeps_sign = column.format.is_signed && table.stored_width(column) == column.format.width;
      if (keeps_sign && bits[at] == '1') word -= std::int64_t{1} << size;
      words[i].push_back(word);
      at += size;
    }
  }
  return words;
}

std::vector<RomSource> random_sources(std::uint64_t seed) {
  Random random(seed);
  std::vector<RomSource> sources;
  for (int i = 0; i < 6; ++i) {
    const TablePtr table = random_table(random, "T" + std::to_string(i));
    sources.push_back({"scheme", "environment", table});
    if (i % 2 == 0) sources.push_back({"scheme", "illumination", table});
  }
  sources.push_back({"other", "environment", sources.front().table});
  return sources;
}

}  // namespace

TEST_CASE("the words of an image are those of the evaluator") {
  Random random(50);
  for (int i = 0; i < 500; ++i) {
    const TablePtr table = random_table(random, "T");
    const TableContents contents = tabulate(*table);
    const std::string image = rom_image(*table, contents);
    const auto lines = std::count(image.begin(), image.end(), '\n');
    REQUIRE(lines == table->entries());
    const auto digits = static_cast<std::size_t>((table->word_bits() + 3) / 4);
    REQUIRE(image.size() == static_cast<std::size_t>(lines) * (digits + 1));
    REQUIRE(image.find_first_not_of("0123456789abcdef\n") == std::string::npos);
    const auto words = parse(image, *table);
    for (std::size_t j = 0; j < words.size(); ++j)
      if (!table->columns[j].mirrors_first) REQUIRE(words[j] == contents.words[j]);
  }
}

TEST_CASE("images and manifest regenerate to the same bytes, whatever the order of their sources") {
  const Folder folder;
  std::vector<RomSource> sources = random_sources(51);
  const auto files = rom_files(sources);
  CHECK(files.size() == 8);
  write_roms(sources, folder.name());
  for (const auto& [name, contents] : files) CHECK(read_file(folder.file(name)) == contents);
  CHECK(outdated_roms(sources, folder.name()).empty());
  std::vector<RomSource> again = random_sources(51);
  std::reverse(again.begin(), again.end());
  CHECK(rom_files(again) == files);
  std::size_t held = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.name())) ++held;
  CHECK(held == files.size());
}

TEST_CASE("images that are missing or changed are told") {
  const Folder folder;
  const std::vector<RomSource> sources = random_sources(52);
  write_roms(sources, folder.name());
  std::ofstream(folder.file("scheme_T1.hex"), std::ios::app) << "0\n";
  std::filesystem::remove(folder.file("scheme_T3.hex"));
  CHECK(outdated_roms(sources, folder.name()) == std::vector<std::string>{"scheme_T1.hex", "scheme_T3.hex"});
  write_roms(sources, folder.name());
  CHECK(outdated_roms(sources, folder.name()).empty());
}

TEST_CASE("the manifest describes every image") {
  const auto files = rom_files(random_sources(53));
  const auto manifest = nlohmann::json::parse(files.at("manifest.json"));
  CHECK(manifest["schema"] == "bumpsim-roms/1");
  REQUIRE(manifest["roms"].size() == files.size() - 1);
  for (const auto& rom : manifest["roms"]) {
    const std::string& image = files.at(rom["image"].get<std::string>());
    CHECK(rom["sha256"] == sha256_hex(image.data(), image.size()));
    CHECK(rom["bits"].get<std::int64_t>() == rom["entries"].get<std::int64_t>() * rom["word_bits"].get<std::int64_t>());
    CHECK(rom["all_codes_checked"] != rom["map"]);
    std::int64_t stored = 0;
    for (const auto& column : rom["columns"]) {
      if (!column.contains("mirrors")) stored += column["stored_bits"].get<std::int64_t>();
      CHECK(column["max_error_in_range"].get<double>() <= column["max_error"].get<double>());
    }
    CHECK(stored == rom["word_bits"].get<std::int64_t>());
  }
  CHECK(manifest["roms"][1]["units"] == nlohmann::json{"environment", "illumination"});
  CHECK(manifest["roms"][0]["scheme"] == "other");
}

TEST_CASE("two tables of one name in one scheme must hold the same words") {
  Random random(54);
  const TablePtr one = random_table(random, "T"), other = random_table(random, "T");
  REQUIRE(rom_image(*one, tabulate(*one)) != rom_image(*other, tabulate(*other)));
  CHECK_NOTHROW(rom_files({{"scheme", "a", one}, {"scheme", "b", std::make_shared<const Table>(*one)}}));
  CHECK_NOTHROW(rom_files({{"scheme", "a", one}, {"other", "a", other}}));
  CHECK_THROWS_WITH(rom_files({{"scheme", "a", one}, {"scheme", "a", other}}),
                    Catch::Contains("'T'") && Catch::Contains("different words"));
}

TEST_CASE("tables of vertex programs are not ROMs") {
  Random random(55);
  Table table = *random_table(random, "T");
  table.index = real();
  CHECK(rom_files({{"scheme", "vertex", std::make_shared<const Table>(table)}}).size() == 1);
}

TEST_CASE("a folder that cannot be written is the user's error, with its path") {
  const Folder folder;
  const std::vector<RomSource> sources = random_sources(56);
  std::filesystem::create_directories(std::filesystem::path(folder.name()).parent_path());
  std::ofstream(folder.name()) << "a file in the way";
  try {
    write_roms(sources, folder.name());
    FAIL("written over a file");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::input);
    CHECK_THAT(error.what(), Catch::Contains(folder.name()));
  }
}

TEST_CASE("a failure leaves the whole earlier set of images, and gives the system's reason") {
  const Folder folder;
  const std::vector<RomSource> before = random_sources(57), after = random_sources(58);
  const std::string failure = GENERATE(as<std::string>{}, "no room", "a folder in the way");
  write_roms(before, folder.name());
  std::ofstream(folder.file("notes.txt")) << "keep";
  if (failure == "a folder in the way") {
    std::filesystem::remove(folder.file("scheme_T5.hex"));
    std::filesystem::create_directory(folder.file("scheme_T5.hex"));
  }
  rlimit old{};
  getrlimit(RLIMIT_FSIZE, &old);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = old;
  if (failure == "no room") small.rlim_cur = rom_files(after).at("manifest.json").size() - 1;
  setrlimit(RLIMIT_FSIZE, &small);
  std::string message;
  try {
    write_roms(after, folder.name());
  } catch (const Error& error) {
    message = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, handler);

  CHECK_THAT(message, Catch::Contains(failure == "no room" ? "File too large" : "Is a directory") && Catch::Contains("try: "));
  for (const auto& [name, contents] : rom_files(before))
    if (failure == "no room" || name != "scheme_T5.hex") CHECK(read_file(folder.file(name)) == contents);
  std::vector<std::string> held;
  for (const auto& entry : std::filesystem::directory_iterator(folder.name())) held.push_back(entry.path().filename().string());
  CHECK(held.size() == rom_files(before).size() + 1);
}

TEST_CASE("a new folder of images that cannot be filled does not appear") {
  const Folder folder;
  const std::vector<RomSource> sources = random_sources(59);
  rlimit old{};
  getrlimit(RLIMIT_FSIZE, &old);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = old;
  small.rlim_cur = rom_files(sources).at("manifest.json").size() - 1;
  setrlimit(RLIMIT_FSIZE, &small);
  CHECK_THROWS_WITH(write_roms(sources, folder.name()), Catch::Contains("File too large"));
  setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, handler);
  CHECK(std::filesystem::is_empty(std::filesystem::path(folder.name()).parent_path()));
  write_roms(sources, folder.name());
  CHECK(outdated_roms(sources, folder.name()).empty());
}
