#include "testbench/scene/obj_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

namespace bump {

namespace {

constexpr double largest_coordinate = 1e30;  // squares and products of what is larger would leave double precision
constexpr const char* allowed_coordinates = "coordinates are allowed from -1e30 to 1e30";
constexpr std::size_t most_corners = 1024;

class ObjParser {
 public:
  explicit ObjParser(const std::string& file) { where_.file = file; }

  ObjText parse(const std::string& text) {
    if (text.find('\0') != std::string::npos) {
      throw Error({"mesh '" + where_.file + "' is not a text file", where_, "OBJ is a text format and this file has binary content", ""});
    }
    std::size_t begin = text.compare(0, 3, "\xef\xbb\xbf") == 0 ? 3 : 0;
    int line = 1;
    while (begin < text.size()) {
      where_.line = line;
      std::string joined;
      for (;;) {  // a backslash at the end continues the line
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        std::size_t length = end - begin;
        while (length > 0 && text[begin + length - 1] == '\r') --length;
        joined.append(text, begin, length);
        begin = end + 1;
        ++line;
        if (joined.empty() || joined.back() != '\\' || begin >= text.size()) break;
        joined.back() = ' ';
      }
      read_line(joined);
    }
    finish();
    return std::move(obj_);
  }

 private:
  [[noreturn]] void fail(const std::string& what, const std::string& why, const std::string& try_this = "re-export the mesh") const {
    throw Error({what, where_, why, try_this});
  }

  void read_line(const std::string& line) {
    std::vector<std::string> words;
    const std::string content = line.substr(0, line.find('#'));
    for (std::size_t at = content.find_first_not_of(" \t"); at != std::string::npos;) {
      const std::size_t end = std::min(content.find_first_of(" \t", at), content.size());
      words.push_back(content.substr(at, end - at));
      at = content.find_first_not_of(" \t", end);
    }
    if (words.empty()) return;
    const std::string& key = words[0];
    if (key == "v") {
      const auto numbers = read_numbers(words, 3);
      obj_.positions.emplace_back(numbers[0], numbers[1], numbers[2]);
    } else if (key == "vt") {
      const auto numbers = read_numbers(words, 2);
      obj_.textures.emplace_back(numbers[0], numbers[1]);
    } else if (key == "vn") {
      const auto numbers = read_numbers(words, 3);
      obj_.normals.emplace_back(numbers[0], numbers[1], numbers[2]);
    } else if (key == "f") {
      read_face(words);
    } else if (key == "usemtl") {
      const std::string name = rest_of(line, key);
      const auto added = material_index_.emplace(name, static_cast<int>(obj_.materials.size()));
      if (added.second) obj_.materials.push_back(name);
      material_ = added.first->second;
    } else if (key == "mtllib") {
      const std::string name = rest_of(line, key);
      if (name.empty()) fail("mtllib names no file", "", "mtllib name.mtl");
      obj_.libraries.push_back({name, where_});
    }
  }

  static std::string rest_of(const std::string& line, const std::string& key) {
    std::size_t at = line.find(key) + key.size();
    at = std::min(line.find_first_not_of(" \t", at), line.size());
    std::string rest = line.substr(at);
    while (!rest.empty() && (rest.back() == ' ' || rest.back() == '\t')) rest.pop_back();
    return rest;
  }

  std::vector<double> read_numbers(const std::vector<std::string>& words, std::size_t count) const {
    if (words.size() < count + 1) {
      fail("'" + words[0] + "' has " + std::to_string(words.size() - 1) + " numbers",
           "it takes at least " + std::to_string(count) + "; is the file cut off here?");
    }
    std::vector<double> numbers(count);
    for (std::size_t i = 0; i < count; ++i) {
      const std::string& word = words[i + 1];
      const char* begin = word.data() + (word.size() > 1 && word[0] == '+' ? 1 : 0);
      const char* end = word.data() + word.size();
      const auto [stop, error] = std::from_chars(begin, end, numbers[i]);
      const bool tiny = error == std::errc::result_out_of_range && word.find_first_of("eE") != std::string::npos &&
                        word[word.find_first_of("eE") + 1] == '-';
      if (tiny) numbers[i] = 0;
      if ((error != std::errc() && !tiny && error != std::errc::result_out_of_range) || stop != end) {
        fail("'" + word + "' is not a number", "'" + words[0] + "' takes numbers");
      }
      if (error == std::errc() && !std::isfinite(numbers[i])) fail("'" + word + "' is not a finite coordinate", allowed_coordinates);
      if ((error != std::errc() && !tiny) || std::abs(numbers[i]) > largest_coordinate)
        fail("'" + word + "' is out of range", allowed_coordinates);
    }
    return numbers;
  }

  void read_face(const std::vector<std::string>& words) {
    if (words.size() < 4) {
      fail("a face has " + std::to_string(words.size() - 1) + " corners", "it takes at least 3; is the file cut off here?");
    }
    if (words.size() - 1 > most_corners)
      fail("a face has " + std::to_string(words.size() - 1) + " corners", "allowed 3 to 1024", "triangulate the mesh");
    ObjFace face;
    face.line = where_.line;
    face.material = material_;
    for (std::size_t i = 1; i < words.size(); ++i) face.corners.push_back(read_corner(words[i]));
    obj_.faces.push_back(std::move(face));
  }

  /// "7", "7/3", "7//2" or "7/3/2"; negative counts back from the latest.
  ObjCorner read_corner(const std::string& word) const {
    long index[3] = {0, 0, 0};
    bool given[3] = {false, false, false};
    std::size_t part = 0, begin = 0;
    for (;; ++part) {
      const std::size_t end = std::min(word.find('/', begin), word.size());
      if (part == 3) fail("'" + word + "' is not a face corner", "it has more than three indices", "f 1/1/1 2/2/2 3/3/3");
      if (end > begin) {
        const auto [stop, error] = std::from_chars(word.data() + begin, word.data() + end, index[part]);
        if (error != std::errc() || stop != word.data() + end)
          fail("'" + word + "' is not a face corner", "indices are whole numbers", "f 1/1/1 2/2/2 3/3/3");
        given[part] = true;
      }
      if (end == word.size()) break;
      begin = end + 1;
    }
    if (!given[0]) fail("'" + word + "' is not a face corner", "it names no vertex", "f 1/1/1 2/2/2 3/3/3");
    ObjCorner corner;
    corner.position = resolve(index[0], obj_.positions.size(), "vertex");
    if (given[1]) corner.texture = resolve(index[1], obj_.textures.size(), "texture coordinate");
    if (given[2]) corner.normal = resolve(index[2], obj_.normals.size(), "normal");
    return corner;
  }

  int resolve(long index, std::size_t count_so_far, const std::string& what) const {
    const long resolved = index > 0 ? index - 1 : static_cast<long>(count_so_far) + index;
    if (index == 0 || resolved < 0 || resolved > 0x7ffffffeL) {
      fail("a face refers to " + what + " " + std::to_string(index),
           index == 0 ? "indices count from 1" : "only " + std::to_string(count_so_far) + " stand before it");
    }
    return static_cast<int>(resolved);
  }

  /// A face may refer to what follows it, so that upper bounds are known only at the end.
  void finish() {
    where_.line = 0;
    if (obj_.positions.empty()) fail("mesh '" + where_.file + "' has no vertices", "there is no line that begins with 'v'");
    if (obj_.faces.empty()) fail("mesh '" + where_.file + "' has no faces", "there is no line that begins with 'f'; is the file cut off?");
    const auto check = [&](int index, std::size_t count, const std::string& what) {
      if (index >= 0 && static_cast<std::size_t>(index) >= count) {
        fail("a face refers to " + what + " " + std::to_string(index + 1), "the file has " + std::to_string(count));
      }
    };
    for (const auto& face : obj_.faces) {
      where_.line = face.line;
      for (const auto& corner : face.corners) {
        check(corner.position, obj_.positions.size(), "vertex");
        check(corner.texture, obj_.textures.size(), "texture coordinate");
        check(corner.normal, obj_.normals.size(), "normal");
      }
    }
  }

  ObjText obj_;
  Location where_;
  std::map<std::string, int> material_index_;
  int material_ = -1;
};

}  // namespace

ObjText parse_obj(const std::string& text, const std::string& file) {
  return ObjParser(file).parse(text);
}

}  // namespace bump
