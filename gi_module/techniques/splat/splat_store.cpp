#include "gi_module/techniques/splat/splat_store.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

namespace lanthorn::gi {

SplatStore::~SplatStore() {
    clear();
}

void SplatStore::limit(std::size_t bytes, std::filesystem::path folder) {
    limit_ = bytes;
    folder_ = std::move(folder);
}

void SplatStore::clear() {
    kept_.clear();
    read_ = {};
    records_ = file_bytes_ = 0;
    memory_ = most_memory_ = 0;
    error_.clear();
    if (file_ >= 0) {
        ::close(file_);
        file_ = -1;
    }
}

std::size_t SplatStore::bytes_of(const RecordRun& run) {
    return run.records.capacity() * sizeof(PhotonRecord) + run.blocks.capacity() * sizeof(PhotonBlock);
}

void SplatStore::count_memory() {
    memory_ = bytes_of(read_);
    for (const Kept& kept : kept_) {
        memory_ += bytes_of(kept.run);
    }
    most_memory_ = std::max(most_memory_, memory_);
}

void SplatStore::fail(const std::string& doing, int error) {
    error_ = "photons on disk: " + doing + ": " + std::generic_category().message(error);
}

// Without a name as soon as it is there: whatever happens to the folder or to this program, nothing is left.
bool SplatStore::open_file() {
    std::error_code code;
    const std::filesystem::path folder =
        folder_.empty() ? std::filesystem::temp_directory_path(code) : folder_;
    if (code) {
        fail("looking for a temporary folder", code.value());
        return false;
    }
    std::string name = (folder / "lanthorn-photons-XXXXXX").string();
    file_ = ::mkostemp(name.data(), O_CLOEXEC);
    if (file_ < 0) {
        fail("making a file in '" + folder.string() + "'", errno);
        return false;
    }
    ::unlink(name.c_str());
    return true;
}

bool SplatStore::write(Kept& kept) {
    if (file_ < 0 && !open_file()) {
        return false;
    }
    const auto* data = reinterpret_cast<const char*>(kept.run.records.data());
    const std::size_t bytes = kept.run.records.size() * sizeof(PhotonRecord);
    for (std::size_t done = 0; done < bytes;) {
        const ssize_t n = ::pwrite(file_, data + done, bytes - done, static_cast<off_t>(file_bytes_ + done));
        if (n < 0 && errno == EINTR) {
            continue;
        }
        if (n <= 0) {
            fail("writing to the temporary file", n < 0 ? errno : ENOSPC);
            return false;
        }
        done += static_cast<std::size_t>(n);
    }
    kept.offset = file_bytes_;
    file_bytes_ += bytes;
    return true;
}

bool SplatStore::add(std::vector<RecordRun> runs) {
    error_.clear();
    const std::size_t before = kept_.size();
    const std::uint64_t file_before = file_bytes_;
    std::size_t records = 0;
    for (RecordRun& run : runs) {
        run.records.shrink_to_fit();
        run.blocks.shrink_to_fit();
        const std::size_t count = run.records.size();
        records += count;
        kept_.push_back({std::move(run), 0, count, false});
    }
    count_memory();
    // What was here before is still here: runs written just now among them are so on disk.
    const auto undo = [&] {
        kept_.resize(before);
        std::uint64_t end = 0;
        for (const Kept& k : kept_) {
            end = k.in_file ? std::max(end, k.offset + k.count * sizeof(PhotonRecord)) : end;
        }
        file_bytes_ = std::max(file_before, end);
        if (file_ >= 0) {  // what was written for nothing; nothing depends on its going
            [[maybe_unused]] const int ignored = ::ftruncate(file_, static_cast<off_t>(file_bytes_));
        }
        count_memory();
    };
    // Room for the run that each() reads; blocks stay in memory.
    const std::size_t reading = kMostRecords * sizeof(PhotonRecord);
    std::size_t blocks = 0;
    for (const Kept& kept : kept_) {
        blocks += kept.run.blocks.capacity() * sizeof(PhotonBlock);
    }
    if (before > 0 && blocks > std::max(limit_, reading)) {
        undo();
        error_ = "photons: what finds them needs all of their memory, gi.splat.memory";
        return false;
    }
    const bool spill = memory_ + (bytes_of(read_) > 0 ? 0 : reading) > limit_;
    for (std::size_t i = 0; spill && i < kept_.size(); ++i) {
        Kept& kept = kept_[i];
        if (kept.in_file) {
            continue;
        }
        if (!write(kept)) {
            undo();
            return false;
        }
        kept.in_file = true;
        kept.run.records = std::vector<PhotonRecord>();  // its memory, too
    }
    count_memory();
    records_ += records;
    return true;
}

bool SplatStore::each(const std::function<void(const RecordRun& run)>& take) {
    for (Kept& kept : kept_) {
        if (!kept.in_file) {
            take(kept.run);
            continue;
        }
        read_.caustic = kept.run.caustic;
        read_.records.reserve(kMostRecords);
        read_.records.resize(kept.count);
        auto* data = reinterpret_cast<char*>(read_.records.data());
        const std::size_t bytes = kept.count * sizeof(PhotonRecord);
        for (std::size_t done = 0; done < bytes;) {
            const ssize_t n =
                ::pread(file_, data + done, bytes - done, static_cast<off_t>(kept.offset + done));
            if (n < 0 && errno == EINTR) {
                continue;
            }
            if (n <= 0) {
                fail("reading the temporary file", n < 0 ? errno : EIO);
                return false;
            }
            done += static_cast<std::size_t>(n);
        }
        // The blocks are lent for the call.
        read_.blocks = std::move(kept.run.blocks);
        count_memory();
        take(read_);
        kept.run.blocks = std::move(read_.blocks);
        read_.blocks = {};
    }
    return true;
}

}  // namespace lanthorn::gi
