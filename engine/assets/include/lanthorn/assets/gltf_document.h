// A glTF file that is read, changed and written again: what is not changed stays as it is in the file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lanthorn/scene/scene_data.h"

namespace lanthorn {

// The document holds the file's JSON as text and patches it in place: members that were not set - unknown
// extras and extensions, names, numbers in any spelling, their order and the white space between them - are
// written with the bytes that they were read with. So are buffers and images: the importer's copies of them
// are never written back.
//
// Indices are the file's own (node 3 is /nodes/3), not those of SceneData; kNone stands for 'none'. A setter
// writes only what differs from what the file says already, so setting what was imported changes nothing.
// Every call that is given an index, number or text that glTF does not allow throws InputError "FILE: JSON
// POINTER: PROBLEM" and leaves the document as it was.
//
// Cost: opening and writing are O(file); a patch is O(what the changed array holds). A copy (for undo, say)
// shares the text that was read and the bytes of buffers. One thread at a time, reading included.
class GltfDocument {
  public:
    // An empty scene.
    GltfDocument();
    // `scene` as a new document: every node, mesh, material, texture, image (as PNG), camera, light, skin and
    // clip. `generator` is asset.generator. Members are sorted and numbers as short as they can be, so the
    // same scene gives the same bytes on every machine. Left out is what an importer makes by itself: normals
    // and tangents of the base, and texture coordinates that no texture of the material uses. Throws
    // InputError for a scene that glTF cannot hold (a number that is not finite, text that is not UTF-8).
    static GltfDocument of_scene(const SceneData& scene, std::string_view generator);
    // Reads .gltf or .glb. External files are not read, only named. Throws InputError as import_gltf does for
    // containers, JSON and references that are broken.
    // Written elsewhere, it takes images outside of its folder along only if `allow_outside`.
    static GltfDocument open(const std::filesystem::path& path, bool allow_outside = false);

    GltfDocument(const GltfDocument& other);
    GltfDocument(GltfDocument&&) noexcept;
    GltfDocument& operator=(const GltfDocument& other);
    GltfDocument& operator=(GltfDocument&&) noexcept;
    ~GltfDocument();

    std::size_t node_count() const;                 // of /nodes, removed ones included
    std::size_t mesh_count() const;                 // of glTF meshes, each with one primitive or more
    std::size_t camera_count() const;               // of /cameras
    std::size_t light_count() const;                // of KHR_lights_punctual
    std::size_t material_count() const;             // of /materials
    std::string node_name(std::size_t node) const;  // empty if it has none
    std::string extras(std::size_t node) const;     // JSON text; empty if it has none

    // --- nodes ---

    // UTF-8; nodes may share a name.
    void set_node_name(std::size_t node, std::string_view name);
    // Metres; unit quaternion; `shear` as in NodeData. Written as translation, rotation and scale, or, with a
    // shear, as a matrix. Finite, and the rotation of unit length to 1 %.
    void set_transform(std::size_t node, const Transform& local, const mat3& shear = mat3(1));
    // All of the node's extras, as JSON text; none: empty.
    void set_extras(std::size_t node, std::string_view json);
    // One member of the node's extras, as JSON text; extras that are no object are refused.
    void set_extra(std::size_t node, std::string_view key, std::string_view json);
    // Nothing if the node has no such member; extras that become empty go.
    void remove_extra(std::size_t node, std::string_view key);
    // The mesh that the node shows; kNone takes it away.
    void set_node_mesh(std::size_t node, std::uint32_t mesh);
    // The camera at the node; kNone takes it away.
    void set_node_camera(std::size_t node, std::uint32_t camera);
    // The light of KHR_lights_punctual at the node; kNone takes it away.
    void set_node_light(std::size_t node, std::uint32_t light);
    // The skin that deforms the node's mesh; kNone takes it away.
    void set_node_skin(std::size_t node, std::uint32_t skin);
    // KHR_node_visibility: false hides the node and what stands under it.
    void set_node_visible(std::size_t node, bool visible);
    // A new node, last among the children of `parent` or the roots of the default scene. Returns its index.
    std::size_t add_node(std::string_view name, std::uint32_t parent = kNone);
    // Makes the node the last child of `parent`, or a root of the default scene. Cycles are refused.
    void set_parent(std::size_t node, std::uint32_t parent);
    // Takes the node, and what stands under it, out of all scenes. Its index stays taken, so that nothing
    // else is renumbered (unknown extensions may name nodes too); set_parent brings it back.
    void remove_node(std::size_t node);

    // --- what nodes show ---

    // Orthographic sizes in metres, more than 0; y_fov in radians, 0.001 to pi - 0.001; z_far beyond z_near,
    // or in perspective 0: infinity.
    void set_camera(std::size_t index, const Camera& camera);
    // Colour and intensity of 0 or more; an infinite range is left out. Of spots the outer cone is 0.001 to
    // pi / 2 radians, the inner one less.
    void set_light(std::size_t index, const Light& light);
    // Factors, alpha mode and sidedness; textures stay as they are. A clear coat, sheen and specular
    // glossiness go: what they say is in the factors that were imported, and glossiness that is a texture
    // becomes one of roughness, which is added as PNG.
    void set_material(std::size_t index, const Material& material);
    // Numbers as in set_camera(). Returns its index; nodes show it by set_node_camera().
    std::size_t add_camera(const Camera& camera);
    // Numbers as in set_light(). Returns its index; nodes show it by set_node_light().
    std::size_t add_light(const Light& light);
    // With textures: TextureRef::texture is an index of the document's textures.
    std::size_t add_material(const Material& material);
    std::size_t add_image(const Image& image);  // as PNG, in a buffer
    // With a sampler of its own; Texture::image is an index of the document's images. Returns its index.
    std::size_t add_texture(const Texture& texture);
    // One glTF mesh of these primitives; their materials are the document's. Bytes go into the BIN chunk, or
    // into a buffer of their own where buffer 0 is somebody's file.
    std::size_t add_mesh(const std::vector<const Mesh*>& primitives);
    // Joints and channels name nodes of the document.
    std::size_t add_skin(const Skin& skin);
    // At least one channel; they name nodes of the document. Keys are written as floats. Returns its index.
    std::size_t add_animation(const AnimationClip& clip);

    // --- writing ---

    // Takes the images that it names as files, byte for byte, into buffer 0, and that and other buffers into
    // itself, so that a .glb is written alone. The warnings name the images that stay named: those that are
    // missing or may not be read. Throws InputError for a buffer that cannot be read, and for a first one
    // that has no bytes (EXT_meshopt_compression's fallback). Reads every file named, once.
    std::vector<std::string> take_in_files();

    // What writing the document has made.
    struct Written {
        std::vector<std::filesystem::path> files;  // the document first
        std::vector<std::string> warnings;         // what was left as it is, each one line
    };
    // Writes the document as .gltf or .glb, as the ending says; what is at `path` is replaced. Between the
    // two, buffer 0 moves into the BIN chunk and back into NAME.bin beside a .gltf; all else stays where it
    // is. In another folder than the one it was read from, files that it names come with it, under the same
    // relative URI, or under their name alone if that leads out of the folder. Either all files appear or, as
    // far as the file system allows, none does. Files beside `path` are replaced only if the document there
    // names them; else NAME-1.bin is taken, and a URI that is taken by another file is refused. A named image
    // that is missing stays named, and a BIN chunk that no buffer is in stays out of a .gltf, with a warning.
    // Throws InputError for an unknown ending, a missing buffer, what the container cannot hold (4 GiB and
    // more in a .glb, chunks of unknown types in a .gltf), a place that cannot be written, and one where a
    // file stands that the document itself is made of.
    Written write(const std::filesystem::path& path) const;
    // The bytes of a .glb. Files that it names stay named.
    std::string glb_bytes() const;
    // The JSON alone, as it would stand in the container that the document was read from.
    std::string json_text() const;

  private:
    struct State;
    friend class GltfWriting;
    friend class PrimitiveWriter;
    std::unique_ptr<State> state_;
};

}  // namespace lanthorn
