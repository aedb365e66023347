// The bytes of an EXR file as a stream for its library.
#pragma once

#include <ImfIO.h>

#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>

namespace lanthorn {

class ExrStream final : public Imf::IStream {
  public:
    explicit ExrStream(std::span<const std::uint8_t> bytes) : IStream("memory"), bytes_(bytes) {}
    bool read(char to[], int size) override {
        const auto wanted = static_cast<std::size_t>(size);
        if (size < 0 || at_ > bytes_.size() || wanted > bytes_.size() - at_) {
            throw std::runtime_error("the file is cut off");
        }
        std::memcpy(to, bytes_.data() + at_, wanted);
        at_ += wanted;
        return at_ < bytes_.size();
    }
    std::uint64_t tellg() override { return at_; }
    void seekg(std::uint64_t at) override { at_ = at; }

  private:
    std::span<const std::uint8_t> bytes_;
    std::uint64_t at_ = 0;
};

}  // namespace lanthorn
