#include <catch2/catch.hpp>

#include "datapath/sha256.h"
#include "random_netlist.h"

using bump::Sha256;
using bump::sha256_hex;

TEST_CASE("SHA-256 gives the digests of FIPS 180-4") {
  const std::string abc = "abc", two_blocks = "abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq", million(1000000, 'a');
  CHECK(sha256_hex(nullptr, 0) == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(sha256_hex(abc.data(), abc.size()) == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(sha256_hex(two_blocks.data(), two_blocks.size()) == "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(sha256_hex(million.data(), million.size()) == "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("a digest does not depend on the pieces that the bytes come in") {
  bump_test::Random random(40);
  for (int i = 0; i < 200; ++i) {
    std::string bytes;
    for (int size = random.integer(0, 300); size > 0; --size) bytes += static_cast<char>(random.integer(0, 255));
    Sha256 hash;
    for (std::size_t at = 0; at < bytes.size();) {
      const std::size_t size = std::min(bytes.size() - at, static_cast<std::size_t>(random.integer(0, 130)));
      hash.update(bytes.data() + at, size);
      at += size;
      if (random.integer(0, 9) == 0) CHECK(hash.hex() == sha256_hex(bytes.data(), at));
    }
    CHECK(hash.hex() == sha256_hex(bytes.data(), bytes.size()));
  }
}
