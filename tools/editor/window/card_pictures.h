// Small pictures of scenes: those that lie beside their files, and those that the editor has kept of files
// that were open.
#pragma once

#include <filesystem>
#include <map>
#include <optional>

#include "lanthorn/core/image.h"
#include "lanthorn/gpu/texture.h"

namespace lanthorn::edit_window {

class CardPictures {
  public:
    static constexpr int kWidth = 256, kHeight = 144;  // of a picture that is kept

    // The folder for those that are kept; empty: none are.
    explicit CardPictures(std::filesystem::path folder = {}) : folder_(std::move(folder)) {}

    // Of a scene's file: NAME.png beside it, or what was kept. Null: there is none, or it is not read yet:
    // one is read a turn, so that the panels never wait for many.
    const gpu::Texture* of(const std::filesystem::path& scene);
    // A new turn begins; whether pictures are still to be read.
    bool next_turn();
    // Keeps a picture of that scene, display-encoded, unless one lies beside it. Nothing where that cannot be
    // written: a card without a picture is one, too.
    void keep(const std::filesystem::path& scene, const ImageF& picture);

  private:
    std::filesystem::path file_of(const std::filesystem::path& scene) const;  // empty: there is none
    std::filesystem::path kept_file(const std::filesystem::path& scene) const;

    std::filesystem::path folder_;
    std::map<std::filesystem::path, std::optional<gpu::Texture>> read_;  // by scene
    bool may_read_ = true, waits_ = false;
};

}  // namespace lanthorn::edit_window
