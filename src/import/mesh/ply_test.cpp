#include "import/mesh/ply.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <fstream>

#include "core/error.h"
#include "import/mesh/gzip.h"
#include "import/mesh/validate_mesh.h"

namespace ajar {
namespace {

const std::string kAsciiQuad =
    "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 4\nproperty float x\nproperty "
    "float y\n"
    "property float z\nproperty float nx\nproperty float ny\nproperty float nz\nproperty float "
    "s\nproperty float t\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0 0 0 1 0 0\n1 0 0 0 0 1 1 0\n1 1 0 0 0 1 1 1\n0 1 0 0 0 1 0 1\n4 0 1 2 3\n";

void expect_quad(const desc::Mesh& mesh) {
  ASSERT_EQ(mesh.positions.size(), 4U);
  EXPECT_EQ(mesh.positions[2], Vec3(1.F, 1.F, 0.F));
  ASSERT_EQ(mesh.indices.size(), 2U);
  EXPECT_EQ(mesh.indices[0], Imath::Vec3<unsigned>(0, 1, 2));
  EXPECT_EQ(mesh.indices[1], Imath::Vec3<unsigned>(0, 2, 3));
}

std::string ply_error_in(std::string_view bytes) {
  try {
    read_ply(bytes, "m.ply");
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

/// Builds binary bodies value by value.
struct Body {
  bool big_endian = false;
  std::string bytes;
  template <typename T>
  Body& add(T value) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (big_endian) std::reverse(raw, raw + sizeof(T));
    bytes.append(raw, sizeof(T));
    return *this;
  }
};

std::string gzip(const std::string& text) {
  z_stream stream = {};
  deflateInit2(&stream, 6, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
  std::string out(deflateBound(&stream, text.size()) + 32, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

TEST(Ply, ReadsAscii) {
  const desc::Mesh mesh = read_ply(kAsciiQuad, "m.ply");
  expect_quad(mesh);
  EXPECT_EQ(mesh.normals[3], Vec3(0.F, 0.F, 1.F));
  EXPECT_EQ(mesh.uvs[1], Vec2(1.F, 0.F));
}

TEST(Ply, ReadsWindowsLineEnds) {
  std::string text;
  for (const char c : kAsciiQuad) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  expect_quad(read_ply(text, "m.ply"));
}

TEST(Ply, WritesWhatItReads) {
  desc::Mesh mesh = read_ply(kAsciiQuad, "m.ply");
  mesh.positions[0] = Vec3(-0.1F, 1e-30F, 3e8F);
  for (int variant = 0; variant < 4; ++variant) {
    desc::Mesh m = mesh;
    if ((variant & 1) != 0) m.normals.clear();
    if ((variant & 2) != 0) m.uvs.clear();
    const desc::Mesh back = read_ply(write_ply(m), "m.ply");
    EXPECT_EQ(back.positions, m.positions);
    EXPECT_EQ(back.normals, m.normals);
    EXPECT_EQ(back.uvs, m.uvs);
    EXPECT_EQ(back.indices, m.indices);
  }
}

TEST(Ply, ReadsBothByteOrdersAndAllTypes) {
  for (const bool big : {false, true}) {
    Body body{big, {}};
    for (const auto& [x, y] :
         {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
      body.add<double>(x)
          .add<std::int16_t>(7)
          .add<std::int8_t>(static_cast<std::int8_t>(y))
          .add<float>(0.F);
    }
    body.add<std::uint8_t>(2).add<float>(1.F).add<float>(2.F);  // an edge element to skip: list
    body.add<float>(0.5F).add<std::uint16_t>(4);
    for (const std::uint16_t i : {0, 1, 2, 3}) body.add<std::uint16_t>(i);
    const std::string header =
        std::string("ply\nformat ") + (big ? "binary_big_endian" : "binary_little_endian") +
        " 1.0\nelement vertex 4\nproperty double x\nproperty short material\nproperty char y\n"
        "property float z\nelement edge 1\nproperty list uchar float ends\nelement face 1\n"
        "property float quality\nproperty list ushort ushort vertex_index\nend_header\n";
    expect_quad(read_ply(header + body.bytes, "m.ply"));
  }
}

TEST(Ply, ReadsFacesOfMixedSizes) {
  Body body;
  for (int i = 0; i < 5; ++i)
    body.add<float>(static_cast<float>(i)).add<float>(static_cast<float>(i * i)).add<float>(0.F);
  for (const std::vector<int>& face :
       std::vector<std::vector<int>>{{0, 1, 2}, {0, 1, 2, 3, 4}, {0, 1}, {2, 3, 4}}) {
    body.add<std::uint8_t>(static_cast<std::uint8_t>(face.size()));
    for (const int i : face) body.add<std::int32_t>(i);
  }
  const std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 5\nproperty float x\nproperty float "
      "y\nproperty float z\n"
      "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
  const desc::Mesh mesh = read_ply(header + body.bytes, "m.ply");
  ASSERT_EQ(mesh.indices.size(), 5U);
  EXPECT_EQ(mesh.indices[3], Imath::Vec3<unsigned>(0, 3, 4));
  EXPECT_EQ(mesh.indices[4], Imath::Vec3<unsigned>(2, 3, 4));
}

TEST(Ply, ReadsGzip) {
  expect_quad(read_ply(gzip(kAsciiQuad), "m.ply.gz"));
  const std::string half = gzip(kAsciiQuad).substr(0, 60);
  EXPECT_EQ(ply_error_in(half), "m.ply: the gzip data is damaged or ends early");
  expect_quad(read_ply(gzip(kAsciiQuad.substr(0, 100)) + gzip(kAsciiQuad.substr(100)), "members"));
}

TEST(Gzip, RefusesToUnpackMoreThanAllowed) {
  const std::string packed = gzip(std::string(1000000, 'x'));
  EXPECT_FALSE(gunzip(packed, 999999));
  EXPECT_EQ(gunzip(packed, 1000000)->size(), 1000000U);
}

TEST(Gzip, StopsAtTheMemoryLimit) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers reserve more memory than any limit allows";
#endif
  const std::string packed = gzip(std::string(200'000'000, '\0'));
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  rlimit before{};
  getrlimit(RLIMIT_AS, &before);
  rlimit tight = before;
  const auto used = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  tight.rlim_cur = std::min<rlim_t>(before.rlim_max, used + 100'000'000);
  setrlimit(RLIMIT_AS, &tight);
  std::string error;
  try {
    gunzip(packed, 1'000'000'000);
  } catch (const std::exception& caught) {
    error = caught.what();
  }
  setrlimit(RLIMIT_AS, &before);
  EXPECT_NE(error.find("unpacked, this file needs "), std::string::npos) << error;
}

TEST(Ply, EveryTruncationIsAnError) {
  const std::string binary = write_ply(read_ply(kAsciiQuad, "m.ply"));
  for (std::size_t size = 0; size < binary.size(); ++size) {
    EXPECT_NE(ply_error_in(binary.substr(0, size)), "no error") << size;
  }
  // The last line break of an ascii file may be missing.
  for (std::size_t size = 0; size + 2 < kAsciiQuad.size(); ++size) {
    EXPECT_NE(ply_error_in(kAsciiQuad.substr(0, size)), "no error") << size;
  }
}

TEST(Ply, ImpossibleCountsAreRefusedBeforeAllocation) {
  std::string bomb = kAsciiQuad;
  bomb.replace(bomb.find("vertex 4"), 8, "vertex 1000000000000");
  EXPECT_NE(ply_error_in(bomb).find("1000000000000 × vertex cannot fit"), std::string::npos);
  bomb = kAsciiQuad;
  bomb.replace(bomb.find("face 1"), 6, "face 18446744073709551615");
  EXPECT_NE(ply_error_in(bomb), "no error");
  bomb.replace(bomb.find("face 1"), 25, "face 99999999999999999999");
  EXPECT_NE(ply_error_in(bomb).find("malformed PLY element count"), std::string::npos);
}

TEST(Ply, HeaderErrorsNameTheLine) {
  EXPECT_EQ(ply_error_in("solid stl\n"), "m.ply: this is not a PLY file");
  EXPECT_NE(ply_error_in("ply\nformat ascii 1.0\nelement vertex x\nend_header\n")
                .find("m.ply:3: malformed PLY element count"),
            std::string::npos);
  EXPECT_NE(ply_error_in("ply\nformat utf7 1.0\n").find("m.ply:2: unknown PLY format"),
            std::string::npos);
  EXPECT_NE(ply_error_in("ply\nformat ascii 1.0\nproperty float x\n").find("m.ply:3"),
            std::string::npos);
  EXPECT_NE(ply_error_in("ply\nformat ascii 1.0\nend_header\n").find("no element \"vertex\""),
            std::string::npos);
}

TEST(ValidateMesh, RefusesBadIndicesAndPositions) {
  const SourceLocation where{std::make_shared<const std::string>("s.pbrt"), 3, 4};
  std::vector<Warning> remarks;
  desc::Mesh mesh = read_ply(kAsciiQuad, "m.ply");
  mesh.indices[1].y = 4;
  EXPECT_THROW(
      try { validate_mesh(mesh, where, remarks); } catch (const SceneError& e) {
        EXPECT_STREQ(e.what(), "s.pbrt:3:4: mesh triangle 1 refers to vertex 4 of 4");
        throw;
      },
      SceneError);
  mesh = read_ply(kAsciiQuad, "m.ply");
  mesh.positions[3].z = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(validate_mesh(mesh, where, remarks), SceneError);
}

TEST(ValidateMesh, DropsTrianglesWithoutAreaAndBadAttributes) {
  std::vector<Warning> remarks;
  desc::Mesh mesh = read_ply(kAsciiQuad, "m.ply");
  mesh.indices.insert(mesh.indices.begin(), {1, 1, 2});
  mesh.normals[0].x = std::numeric_limits<float>::infinity();
  mesh.uvs.pop_back();
  validate_mesh(mesh, {}, remarks);
  expect_quad(mesh);
  EXPECT_TRUE(mesh.normals.empty());
  EXPECT_TRUE(mesh.uvs.empty());
  EXPECT_EQ(remarks.size(), 3U);
}

TEST(ValidateMesh, KeepsTrianglesThatAreOnlySmall) {
  desc::Mesh mesh;
  mesh.positions = {{0.F, 0.F, 0.F}, {1e-25F, 0.F, 0.F}, {0.F, 1e-25F, 0.F}};
  mesh.indices.emplace_back(0, 1, 2);
  std::vector<Warning> remarks;
  validate_mesh(mesh, {}, remarks);
  EXPECT_EQ(mesh.indices.size(), 1U);
  EXPECT_TRUE(remarks.empty());
}

/// Half of the light is 188 of 255.
TEST(Ply, ColorsOfVerticesAreThoseOfADisplay) {
  const auto file = [](const std::string& type, const std::string& half) {
    std::string text = "ply\nformat ascii 1.0\nelement vertex 3\n";
    for (const char* axis : {"x", "y", "z"}) text += std::string("property float ") + axis + "\n";
    for (const char* lane : {"red", "green", "blue"})
      text += "property " + type + " " + lane + "\n";
    text += "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    return text + "0 0 0 0 0 0\n1 0 0 " + half + " 0 0\n0 1 0 0 0 " + half + "\n3 0 1 2\n";
  };
  for (const auto& [type, half] : {std::pair("uchar", "188"), std::pair("float", "0.7374")}) {
    const PlyContents contents = read_ply_contents(file(type, half), "a.ply");
    ASSERT_EQ(contents.colors.size(), 3U);
    EXPECT_EQ(contents.colors[0], Vec3(0.F));
    EXPECT_NEAR(contents.colors[1].x, 0.503F, 2e-3F);
    EXPECT_EQ(contents.colors[1].y, 0.F);
    EXPECT_NEAR(contents.colors[2].z, 0.503F, 2e-3F);
    EXPECT_TRUE(contents.skipped.empty());
  }
  const PlyContents odd = read_ply_contents(file("float", "nan"), "a.ply");
  EXPECT_EQ(odd.colors[1], Vec3(0.F));
}

TEST(Ply, StripsAreTriangles) {
  const std::string vertices =
      "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float "
      "z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
      "0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n2 1 0\n";
  const PlyContents contents = read_ply_contents(vertices + "10 0 2 1 3 -1 4 4 5 3 2\n", "a.ply");
  // The second strip has a triangle of no area in it.
  EXPECT_EQ(contents.mesh.indices,
            (std::vector<Imath::Vec3<unsigned>>{{0, 2, 1}, {1, 2, 3}, {5, 4, 3}, {5, 3, 2}}));
  EXPECT_TRUE(contents.skipped.empty());
  EXPECT_NE(ply_error_in(vertices + "3 0 1 -2\n").find("tristrips 0 has an index"),
            std::string::npos);
}

TEST(Ply, SkippedElementsAreReported) {
  const PlyContents contents = read_ply_contents(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
      "z\nproperty uchar red\nelement face 1\nproperty list uchar int vertex_indices\nproperty int "
      "flags\nelement edge 1\nproperty int a\nend_header\n0 0 0 9\n1 0 0 9\n0 1 0 9\n3 0 1 2 "
      "7\n5\n",
      "a.ply");
  EXPECT_EQ(contents.skipped, (std::vector<std::string>{"red", "flags", "edge"}));
  EXPECT_EQ(contents.mesh.indices.size(), 1U);
}

TEST(Ply, ColorsOfFloatsMayBeThoseOfBytes) {
  const auto second_of = [](const std::string& second) {
    const std::string text =
        "ply\nformat ascii 1.0\ncomment\nelement vertex 3\nproperty float x\nproperty float "
        "y\nproperty float z\nproperty float red\nproperty float green\nproperty float "
        "blue\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0 0 0 0\n1 0 0 " +
        second + "\n0 1 0 0.5 0.5 0.5\n3 0 1 2\n";
    return read_ply_contents(text, "a.ply").colors.at(1);
  };
  EXPECT_LT(length(second_of("188 0.5 255") - Vec3(0.503F, 0.0002F, 1.F)), 1e-3F);
  EXPECT_LT(length(second_of("0.7373 0 1.5") - Vec3(0.503F, 0.F, 1.F)), 1e-3F) << "shares";
}

}  // namespace
}  // namespace ajar
