// Snapshots as bytes: magic, version, hash of the schema, hash of what follows; the schema as JSON; entity
// numbers, tables, resources. In the machine's own order of bytes.
#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "engine/ecs/stored_schema.h"
#include "engine/ecs/value_ops.h"
#include "lanthorn/core/error.h"
#include "lanthorn/ecs/snapshot.h"

namespace lanthorn::ecs {
namespace {

constexpr std::string_view kMagic = "LANTSNAP";

struct Header {
    char magic[8];
    std::uint32_t version;
    std::uint32_t header_size;
    std::uint64_t schema;
    std::uint64_t content;
};

void put(std::string& bytes, std::uint64_t number) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

template <class T>
void put_all(std::string& bytes, const std::vector<T>& values) {
    put(bytes, values.size());
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

bool take(std::span<const std::byte>& bytes, std::uint64_t& number) {
    if (bytes.size() < sizeof number) {
        return false;
    }
    std::memcpy(&number, bytes.data(), sizeof number);
    bytes = bytes.subspan(sizeof number);
    return true;
}

template <class T>
bool take_all(std::span<const std::byte>& bytes, std::vector<T>& values) {
    std::uint64_t count = 0;
    if (!take(bytes, count) || count > bytes.size() / sizeof(T)) {
        return false;
    }
    values.resize(count);
    if (count > 0) {
        std::memcpy(values.data(), bytes.data(), count * sizeof(T));
    }
    bytes = bytes.subspan(count * sizeof(T));
    return true;
}

}  // namespace

std::string Snapshot::to_bytes() const {
    std::string content;
    const std::string schema = detail::schema_text(*registry_);
    put(content, schema.size());
    content += schema;
    put_all(content, numbers_.generations);
    put_all(content, numbers_.links);
    put_all(content, numbers_.pages);
    put(content, numbers_.next);
    put(content, numbers_.free_head);
    put(content, tables_.size());
    for (const Table& table : tables_) {
        std::vector<std::uint32_t> stored;
        for (std::size_t k = 0; k < registry_->components().size(); ++k) {
            if (!registry_->components()[k].opaque) {
                for (const SnapshotColumn& column : table.columns) {
                    if (&column.type() == &registry_->components()[k]) {
                        stored.push_back(static_cast<std::uint32_t>(k));
                    }
                }
            }
        }
        put_all(content, table.entities);
        put_all(content, stored);
        for (const std::uint32_t k : stored) {
            for (const SnapshotColumn& column : table.columns) {
                for (std::size_t i = 0;
                     &column.type() == &registry_->components()[k] && i < table.entities.size(); ++i) {
                    append_bytes(*column.type().value, column.row(i), Fields::all, content);
                }
            }
        }
    }
    for (std::size_t i = 0; i < resources_.size(); ++i) {
        const void* const saved = resources_[i] ? resources_[i]->get() : nullptr;
        put(content, saved != nullptr ? 1 : 0);
        if (saved != nullptr) {
            append_bytes(*registry_->resources()[i].value, saved, Fields::all, content);
        }
    }
    Header header{};
    std::memcpy(header.magic, kMagic.data(), kMagic.size());
    header.version = kVersion;
    header.header_size = sizeof header;
    header.schema = registry_->schema_hash();
    header.content = XXH3_64bits(content.data(), content.size());
    return std::string(reinterpret_cast<const char*>(&header), sizeof header) + content;
}

class Snapshot::Reading {
  public:
    Reading(Snapshot& snapshot, std::span<const std::byte> bytes, bool same_schema)
        : snapshot_(snapshot), bytes_(bytes), same_schema_(same_schema), values_(snapshot.left_out_) {}

    // False for what cannot be a snapshot.
    bool read() {
        std::string schema;
        if (!read_text(schema)) {
            return false;
        }
        schema_ = detail::read_schema(schema);
        find_targets();
        std::uint64_t tables = 0;
        if (!read_numbers() || !take(bytes_, tables)) {
            return false;
        }
        for (std::uint64_t t = 0; t < tables; ++t) {
            if (!read_table(snapshot_.tables_.emplace_back())) {
                return false;
            }
        }
        return read_resources() && bytes_.empty();
    }

  private:
    bool read_text(std::string& text) {
        std::uint64_t size = 0;
        if (!take(bytes_, size) || size > bytes_.size()) {
            return false;
        }
        text.assign(reinterpret_cast<const char*>(bytes_.data()), size);
        bytes_ = bytes_.subspan(size);
        return true;
    }

    bool read_numbers() {
        EntityTable::Numbers& numbers = snapshot_.numbers_;
        std::uint64_t next = 0;
        std::uint64_t free_head = 0;
        if (!take_all(bytes_, numbers.generations) || !take_all(bytes_, numbers.links) ||
            !take_all(bytes_, numbers.pages) || !take(bytes_, next) || !take(bytes_, free_head)) {
            return false;
        }
        numbers.next = static_cast<std::uint32_t>(next);
        numbers.free_head = static_cast<std::uint32_t>(free_head);
        return true;
    }

    // Who takes what was stored, and what was not.
    void find_targets() {
        for (const detail::StoredSchema::Declared& stored : schema_.components) {
            const ComponentType* type = snapshot_.registry_->find(stored.name);
            const bool fits = type != nullptr && type->initial != nullptr && !type->opaque &&
                              stored.type.kind == ValueKind::structure;
            targets_.push_back(fits ? type : nullptr);
        }
        for (const ComponentType& type : snapshot_.registry_->components()) {
            const auto found = std::ranges::find(targets_, &type);
            if (found == targets_.end()) {
                snapshot_.new_types_.push_back(&type);
            } else {
                find_new_fields(type, schema_.components[static_cast<std::size_t>(found - targets_.begin())]);
            }
        }
    }
    void find_new_fields(const ComponentType& type, const detail::StoredSchema::Declared& stored) {
        for (const Field& field : type.value->fields) {
            if (std::ranges::find(stored.type.fields, field.name, &detail::StoredField::name) ==
                stored.type.fields.end()) {
                snapshot_.new_fields_[&type].push_back(&field);
            }
        }
    }

    bool read_value(const detail::StoredSchema::Declared& stored, const DeclaredType* to, void* value) {
        return to != nullptr && same_schema_
                   ? read_bytes(*to->value, value, bytes_)
                   : values_.read(stored.type, bytes_, to != nullptr ? to->value : nullptr, value,
                                  stored.name);
    }

    bool read_table(Table& table) {
        std::vector<std::uint32_t> stored;
        if (!take_all(bytes_, table.entities) || !take_all(bytes_, stored)) {
            return false;
        }
        table.columns.reserve(stored.size());
        for (const std::uint32_t k : stored) {
            if (k >= targets_.size()) {
                return false;
            }
            const ComponentType* type = targets_[k];
            if (type == nullptr) {
                values_.leave_out(schema_.components[k].name);
            } else {
                table.columns.emplace_back(*type, table.entities.size());
            }
            for (std::size_t i = 0; i < table.entities.size(); ++i) {
                void* value = nullptr;
                if (type != nullptr) {
                    table.columns.back().append(type->initial.get(), 1);
                    value = table.columns.back().row(i);
                }
                if (!read_value(schema_.components[k], type, value)) {
                    return false;
                }
            }
        }
        return true;
    }

    bool read_resources() {
        const auto& declared = snapshot_.registry_->resources();
        snapshot_.resources_.resize(declared.size());
        for (const detail::StoredSchema::Declared& stored : schema_.resources) {
            const auto type = std::ranges::find(declared, stored.name, &ResourceType::name);
            std::uint64_t present = 0;
            if (!take(bytes_, present)) {
                return false;
            }
            std::shared_ptr<void> value;
            if (type == declared.end()) {
                values_.leave_out(stored.name);
            } else {
                value = present != 0 ? type->clone(type->initial.get()) : nullptr;
                snapshot_.resources_[static_cast<std::size_t>(type - declared.begin())] = value;
            }
            if (present != 0 && !read_value(stored, type == declared.end() ? nullptr : &*type, value.get())) {
                return false;
            }
        }
        return true;
    }

    Snapshot& snapshot_;
    std::span<const std::byte> bytes_;
    bool same_schema_;
    detail::StoredReader values_;
    detail::StoredSchema schema_;
    std::vector<const ComponentType*> targets_;  // as schema_.components; null: nothing is like it
};

Snapshot Snapshot::from_bytes(std::string_view bytes, const Registry& registry, std::string_view source) {
    Header header{};
    if (bytes.size() < sizeof header || bytes.substr(0, kMagic.size()) != kMagic) {
        throw InputError(source, "", "is no snapshot, expected one that Lanthorn wrote");
    }
    std::memcpy(&header, bytes.data(), sizeof header);
    if (header.version != kVersion || header.header_size != sizeof header) {
        throw InputError(source, "",
                         "is a snapshot of version " + std::to_string(header.version) +
                             ", expected version " + std::to_string(kVersion));
    }
    const std::string_view content = bytes.substr(sizeof header);
    Snapshot snapshot(registry);
    snapshot.stored_ = true;
    bool whole = header.content == XXH3_64bits(content.data(), content.size());
    try {
        const bool same_schema = header.schema == registry.schema_hash();
        whole = whole && Reading(snapshot, std::as_bytes(std::span(content)), same_schema).read();
    } catch (const InputError&) {
        whole = false;
    } catch (const nlohmann::json::exception&) {
        whole = false;
    }
    if (!whole) {
        throw InputError(source, "", "is a damaged snapshot, expected it as it was written");
    }
    std::ranges::sort(snapshot.left_out_);
    return snapshot;
}

}  // namespace lanthorn::ecs
