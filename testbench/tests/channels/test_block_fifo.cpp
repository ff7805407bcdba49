#include <catch2/catch.hpp>
#include <functional>
#include <vector>

#include "channels/block_fifo.h"

using namespace bump;

namespace {

struct Process : public sc_core::sc_module {
  Process(sc_core::sc_module_name name, std::function<void()> body) : sc_module(name), body_(std::move(body)) {
    SC_HAS_PROCESS(Process);
    SC_THREAD(run);
  }
  void run() { body_(); }

 private:
  std::function<void()> body_;
};

}  // namespace

TEST_CASE("blocks arrive complete, in order and within the capacity, whichever side is faster") {
  constexpr int blocks = 50;
  std::vector<std::unique_ptr<BlockFifo<int>>> fifos;
  std::vector<std::unique_ptr<Process>> processes;
  std::vector<std::vector<int>> received(12);
  std::size_t finished = 0;
  for (std::size_t i = 0; i < received.size(); ++i) {
    const std::size_t capacity = 1 + i / 4;
    const bool slow_writer = i % 2 == 1, slow_reader = i % 4 >= 2;
    fifos.push_back(std::make_unique<BlockFifo<int>>("fifo" + std::to_string(i), capacity));
    BlockFifo<int>& fifo = *fifos.back();
    processes.push_back(std::make_unique<Process>(("writer" + std::to_string(i)).c_str(), [&fifo, slow_writer, capacity] {
      for (int k = 0; k < blocks; ++k) {
        if (slow_writer) sc_core::wait(sc_core::SC_ZERO_TIME);
        fifo.write(std::make_unique<int>(k));
        REQUIRE(fifo.size() <= capacity);
      }
      fifo.close();
      fifo.close();
    }));
    processes.push_back(std::make_unique<Process>(("reader" + std::to_string(i)).c_str(), [&, i, slow_reader] {
      while (const auto block = fifo.read()) {
        received[i].push_back(*block);
        if (slow_reader) sc_core::wait(1, sc_core::SC_NS);
      }
      REQUIRE(fifo.read() == nullptr);  // the end stays the end
      ++finished;
    }));
  }
  sc_core::sc_start();
  REQUIRE(finished == received.size());
  std::vector<int> sent;
  for (int k = 0; k < blocks; ++k) sent.push_back(k);
  for (const std::vector<int>& each : received) REQUIRE(each == sent);
}

TEST_CASE("a block channel needs room for a block, and takes none after its end") {
  REQUIRE_THROWS_AS(BlockFifo<int>("none", 0), Error);
  BlockFifo<int> fifo("fifo");
  REQUIRE_THROWS_AS(fifo.write(nullptr), Error);
  fifo.write(std::make_unique<int>(1));
  REQUIRE(fifo.size() == 1);
  fifo.close();
  REQUIRE_THROWS_AS(fifo.write(std::make_unique<int>(2)), Error);
  REQUIRE(*fifo.read() == 1);
  REQUIRE(fifo.read() == nullptr);
}
