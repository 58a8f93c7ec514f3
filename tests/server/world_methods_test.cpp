// Tests for server/methods/world_methods.cpp, hand_methods.cpp, grasp_methods.cpp and
// world_requests.cpp: requests as clients send them.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "api/grasp.h"
#include "base/error.h"
#include "base/file_io.h"
#include "live/world/live_world.h"
#include "questions/question.h"
#include "report/answers/grasp.h"
#include "report/picture/mesh_table.h"
#include "server/methods/method_table.h"
#include "server/methods/world_requests.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A session of its own, and its requests.
class Client {
 public:
  explicit Client(const std::string& folder = "methods")
      : folder_((fs::path(testing::TempDir()) / ("thenar_" + folder)).string()),
        session_({kData, folder_}) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }

  OrderedJson ask(const std::string& name, const Json& params = Json::object()) {
    static const MethodTable table = method_table();
    const RpcMethod& method = table.method_named(name);
    return method.handler(session_, validated(method.params, params, "params"), {});
  }

  /// What a request is refused with; "" if it is not.
  std::string refusal(const std::string& name, const Json& params = Json::object()) {
    try {
      (void)ask(name, params);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  [[nodiscard]] const std::string& folder() const { return folder_; }
  [[nodiscard]] Session& session() { return session_; }

 private:
  std::string folder_;
  Session session_;
};

bool is_ours(const std::string& name) {
  return name.rfind("world.", 0) == 0 || name.rfind("hand.", 0) == 0 ||
         name.rfind("grasp.", 0) == 0;
}

std::string bytes_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

Json dropped(const std::string& name, const std::string& bytes) {
  return {{"name", name},
          {"data", base64(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size())}};
}

TEST(WorldMethods, ExamplesRunOneAfterTheOther) {
  Client client;
  const MethodTable table = method_table();
  int asked = 0;
  for (const RpcMethod& method : table.methods()) {
    if (!is_ours(method.name)) continue;
    EXPECT_EQ(client.refusal(method.name, Json::parse(method.example)), "") << method.name;
    ++asked;
    // After two hands and two objects only their own.
    if (method.name == "world.add_hand") (void)client.ask("world.remove", {{"name", "barrett"}});
    if (method.name == "world.import") (void)client.ask("world.remove", {{"name", "wedge"}});
  }
  EXPECT_GE(asked, 20);
}

TEST(WorldMethods, NameTheOpenerWhereNoWorldIsOpen) {
  Client client;
  EXPECT_THAT(client.refusal("world.get"), HasSubstr("world.new or world.load"));
  (void)client.ask("world.new");
  EXPECT_EQ(client.ask("world.get")["hands"].size(), 0U);
  EXPECT_EQ(client.session().mode(), LiveMode::kWorld);
}

TEST(WorldMethods, TellWhatStandsInTheWorld) {
  Client client;
  (void)client.ask("world.load", {{"world", "jaw_box"}});
  const OrderedJson world = client.ask("world.get");
  ASSERT_EQ(world["hands"].size(), 1U);
  EXPECT_EQ(world["hands"][0]["name"], "parallel_jaw");
  EXPECT_NEAR(world["hands"][0]["joints"]["opening"].get<double>(), 0.05, 1e-15);
  ASSERT_EQ(world["bodies"].size(), 3U);
  EXPECT_EQ(world["bodies"][0]["dynamic"], true);
  // The box is turned by 90 degrees about z.
  EXPECT_NEAR(world["bodies"][0]["rotation"][0].get<double>(), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(world["bodies"][0]["rotation"][3].get<double>(), std::sqrt(0.5), 1e-12);
}

TEST(WorldMethods, PlaceByQuaternions) {
  Client client;
  (void)client.ask("world.load", {{"world", "jaw_box"}});
  const Json turn{0.5, 0.5, 0.5, 0.5};
  (void)client.ask("world.place", {{"name", "box"}, {"rotation", turn}});
  const OrderedJson box = client.ask("world.get")["bodies"][0];
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(box["rotation"][i].get<double>(), 0.5, 1e-12);
  EXPECT_EQ(box["position"][2], 0.12);  // stays
}

// The gears of a finger of the Barrett hand turn J3 by a third of J2, until a clutch opens.
TEST(HandMethods, MoveBothJointsOfABarrettFingerAndTellWhereTheyPart) {
  Client client;
  (void)client.ask("world.load", {{"world", "barrett_bobbin"}});
  const OrderedJson led = client.ask("hand.set_joints", {{"joints", {{"finger 1 J3", 0.3}}}});
  EXPECT_EQ(led["joints"]["finger 1 J3"], 0.3);
  EXPECT_NEAR(led["joints"]["finger 1 J2"].get<double>(), 0.9, 1e-8);
  EXPECT_EQ(led["joints"]["finger 2 J2"], 0.0);
  EXPECT_EQ(led["parted"], OrderedJson::array());
  const OrderedJson open =
      client.ask("hand.set_joints", {{"joints", {{"finger 1 J2", 0.6}, {"finger 1 J3", 0.3}}}});
  EXPECT_EQ(open["joints"]["finger 1 J2"], 0.6);
  EXPECT_EQ(open["parted"], OrderedJson({"finger 1 J3"}));
}

TEST(GraspMethods, AnswerAsTheCommandDoes) {
  for (const char* world : {"barrett_bobbin", "jaw_box", "human_mug"}) {
    Client client;
    (void)client.ask("world.load", {{"world", world}});
    const OrderedJson closed = client.ask("hand.grasp");
    GraspRequest request;
    request.world.world = world;
    request.world.data = kData;
    OrderedJson told = json_of(measure_grasp(request));
    OrderedJson found = client.ask("grasp.measure");
    told.erase("cpu_s");
    EXPECT_EQ(closed["outcome"], "grasped");
    EXPECT_EQ(found, told) << world;
    const OrderedJson quality = client.ask("grasp.quality");
    EXPECT_EQ(quality["epsilon"], told["epsilon"]);
    EXPECT_EQ(quality["force_closure"], told["force_closure"]);
    EXPECT_EQ(quality["worst_wrench"], told["worst_wrench"]);
    EXPECT_EQ(quality["verdict"], "force closure");
    EXPECT_EQ(closed["explanation"], told["explanation"]);
  }
}

TEST(GraspMethods, SayWhyThereIsNoGrasp) {
  Client client;
  (void)client.ask("world.load", {{"world", "barrett_bobbin"}});
  const OrderedJson open = client.ask("grasp.quality");
  EXPECT_EQ(open["closed"], false);
  EXPECT_EQ(open["epsilon"], nullptr);
  EXPECT_NE(open["reason"], nullptr);
  (void)client.ask("hand.approach");
  const OrderedJson touching = client.ask("grasp.quality");
  EXPECT_EQ(touching["closed"], true);
  EXPECT_EQ(touching["force_closure"], false);
  EXPECT_THAT(touching["verdict"].get<std::string>(), HasSubstr("unstable: the grasp cannot push"));
  EXPECT_NE(touching["missing_direction"], nullptr);
  EXPECT_EQ(client.ask("grasp.measure")["outcome"], "touched");
}

TEST(GraspMethods, RefuseAxesThatRepeat) {
  Client client;
  (void)client.ask("world.load", {{"world", "barrett_bobbin"}});
  (void)client.ask("hand.grasp");
  EXPECT_NE(client.refusal("grasp.wrench_set", {{"axes", {0, 0, 1}}}), "");
  const OrderedJson mesh = client.ask("grasp.wrench_set", {{"axes", {3, 4, 5}}, {"pieces", 2}});
  EXPECT_EQ(mesh["vertices"].size(), 4U * 2 * 2 + 2);  // as wrench_set_mesh() says
  EXPECT_EQ(mesh["failed"], 0);
  EXPECT_EQ(client.refusal("grasp.wrench_set", {{"limits", "actuated"}, {"pieces", 2}}), "");
}

// ---- imports

/// A gripper of two fingers with a mesh, as URDF.
std::string small_urdf() {
  const auto finger = [](const std::string& name, const std::string& y, const std::string& axis) {
    return "<link name='" + name +
           "'><collision><origin xyz='0 0 0.05'/><geometry>"
           "<mesh filename='package://pack/meshes/tip.obj' scale='0.001 0.001 0.001'/></geometry>"
           "</collision></link><joint name='j_" +
           name +
           "' type='prismatic'><parent link='base'/>"
           "<child link='" +
           name + "'/><origin xyz='0 " + y + " 0'/><axis xyz='0 " + axis +
           " 0'/><limit lower='0' upper='0.04' effort='10' velocity='1'/></joint>";
  };
  return "<robot name='small'><link name='base'><collision><geometry><box size='0.1 0.1 0.02'/>"
         "</geometry></collision></link>" +
         finger("left", "0.05", "-1") + finger("right", "-0.05", "1") + "</robot>";
}

std::string cube_obj() {
  return "v -5 -5 -5\nv 5 -5 -5\nv 5 5 -5\nv -5 5 -5\nv -5 -5 5\nv 5 -5 5\nv 5 5 5\nv -5 5 5\n"
         "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
}

TEST(WorldMethods, ImportARobotWithItsMeshesAndSaveItAlong) {
  Client client("import");
  const Json files{dropped("pack/meshes/tip.obj", cube_obj()),
                   dropped("pack/robot.urdf", small_urdf())};
  const OrderedJson added = client.ask("world.import", {{"files", files}, {"as", "hand"}});
  EXPECT_EQ(added["name"], "robot");
  for (const auto& warning : added["warnings"])
    EXPECT_THAT(warning.get<std::string>(), testing::Not(HasSubstr("/tmp")));
  EXPECT_EQ(client.ask("hand.get")["joints"].size(), 2U);
  // A text without its files would not load again.
  EXPECT_THAT(client.refusal("world.text"), HasSubstr("'robot' were imported"));
  // A folder of somebody else beside the file stays as it is.
  fs::create_directories(client.folder() + "/held_files/1");
  (void)client.ask("world.save", {{"file", "held.toml"}});
  EXPECT_TRUE(fs::is_empty(client.folder() + "/held_files/1"));
  EXPECT_TRUE(fs::exists(client.folder() + "/held_files/2/pack/robot.urdf"));
  // Saved, and loaded by another session once the first one is gone.
  (void)client.ask("world.save", {{"file", "kept.toml"}});
  const std::string toml = bytes_of_file(client.folder() + "/kept.toml");
  EXPECT_THAT(toml, HasSubstr("\"kept_files/1/pack/robot.urdf\""));
  Client other("other");
  (void)other.ask("world.load", {{"world", client.folder() + "/kept.toml"}});
  EXPECT_EQ(other.ask("hand.get")["joints"].size(), 2U);
  EXPECT_GE(other.session().shown_model()->shape().bodies.size(), 3U);
  // What the refusal of a text advises: what was saved is loaded, and has a text.
  EXPECT_THAT(client.refusal("world.text"), HasSubstr("load what was saved"));
  (void)client.ask("hand.set_joints", {{"joints", {{"j_left", 0.02}}}});
  (void)client.ask("world.save", {{"file", "kept.toml"}});
  (void)client.ask("world.load", {{"world", client.folder() + "/kept.toml"}});
  const OrderedJson text = client.ask("world.text");
  (void)client.ask("world.load", {{"text", text["toml"]}});
  EXPECT_EQ(client.ask("world.get")["hands"][0]["joints"]["j_left"], 0.02);
}

// Each session numbers what is dropped into it from 1 on: a world that came with files has that
// number already.
TEST(WorldMethods, KeepFilesOfHandsThatWereSavedBefore) {
  Client first("keep");
  const Json drop{dropped("robot.urdf", small_urdf())};
  (void)first.ask("world.import", {{"files", drop}, {"as", "hand"}});
  (void)first.ask("world.save", {{"file", "kept.toml"}});
  // In a second session, another hand of the same name joins it.
  Client second("keep_again");
  fs::copy(first.folder(), second.folder(), fs::copy_options::recursive);
  std::string wider = small_urdf();
  wider.replace(wider.find("0.1 0.1 0.02"), 12, "0.2 0.1 0.02");
  (void)second.ask("world.load", {{"world", second.folder() + "/kept.toml"}});
  (void)second.ask("world.import", {{"files", {dropped("robot.urdf", wider)}}, {"as", "hand"}});
  for (int times = 0; times < 3; ++times) {
    (void)second.ask("world.save", {{"file", "kept.toml"}});
    EXPECT_EQ(bytes_of_file(second.folder() + "/kept_files/1/robot.urdf"), small_urdf());
    EXPECT_EQ(bytes_of_file(second.folder() + "/kept_files/2/robot.urdf"), wider);
    EXPECT_FALSE(fs::exists(second.folder() + "/kept_files/3"));
  }
  const std::string toml = bytes_of_file(second.folder() + "/kept.toml");
  EXPECT_THAT(toml, HasSubstr("\"kept_files/1/robot.urdf\""));
  EXPECT_THAT(toml, HasSubstr("\"kept_files/2/robot.urdf\""));
  // What somebody changed there by hand is not lost either, nor where all may be replaced.
  write_file(second.folder() + "/kept_files/2/robot.urdf", "<robot name='mine'/>");
  (void)second.ask("world.save", {{"file", "kept.toml"}, {"overwrite", true}});
  EXPECT_EQ(bytes_of_file(second.folder() + "/kept_files/2/robot.urdf"), "<robot name='mine'/>");
  EXPECT_EQ(bytes_of_file(second.folder() + "/kept_files/3/robot.urdf"), wider);
}

TEST(WorldMethods, ImportAMeshAndForgetWhereItCameFrom) {
  Client client("mesh");
  std::string obj = cube_obj();  // 10 m: scaled to 10 mm
  for (std::size_t at = 0; (at = obj.find('5', at)) != std::string::npos; at += 5)
    if (obj[at - 1] != 'f' && at < obj.find('f')) obj.replace(at, 1, "0.005");
  const OrderedJson added = client.ask(
      "world.import",
      {{"files", {dropped("cube.mtl", ""), dropped("cube.obj", obj)}}, {"as", "object"}});
  EXPECT_EQ(added["name"], "cube");
  const OrderedJson text = client.ask("world.text");
  EXPECT_THAT(text["toml"].get<std::string>(), testing::Not(HasSubstr("/tmp")));
  Client other("mesh2");
  (void)other.ask("world.load", {{"text", text["toml"]}});
  EXPECT_EQ(other.session().shown_model()->shape().bodies[0].mesh->triangles.cols(), 12);
}

// A world keeps the files of hands for undone steps; they must not fill the disk.
TEST(WorldMethods, KeepImportedHandsUpToALimit) {
  Client client("many");
  const Json files{dropped("pack/meshes/tip.obj", cube_obj()),
                   dropped("pack/robot.urdf", small_urdf())};
  const Json import{{"files", files}, {"as", "hand"}};
  EXPECT_EQ(client.refusal("world.import", import), "");
  auto& live = client.session().model<LiveWorld>(LiveMode::kWorld);
  const std::string filler = live.own_folder() + "/1/filler";
  std::ofstream(filler) << "x";
  fs::resize_file(filler, 256UL << 20U);  // a hole, which takes no room
  EXPECT_THAT(client.refusal("world.import", import), HasSubstr("at most 256 MB in all"));
  fs::remove(filler);
  EXPECT_EQ(client.refusal("world.import", import), "");
}

/// Members of a schema whose texts may hold anything, as "params.files.data".
// NOLINTNEXTLINE(misc-no-recursion): as deep as the schema
void add_contents(const Schema& schema, const std::string& where, std::vector<std::string>& found) {
  if (schema.kind == Schema::Kind::kText && schema.words.empty() && !schema.use)
    found.push_back(where);
  if (schema.element != nullptr) add_contents(*schema.element, where, found);
  for (const SchemaMember& member : schema.members)
    add_contents(member.schema, where + "." + member.name, found);
}

// A new method that takes a name or a path has it checked, unless it is added here.
TEST(WorldMethods, TextsOfAllMethodsAreNamesButForContents) {
  std::vector<std::string> found;
  const MethodTable table = method_table();
  for (const RpcMethod& method : table.methods()) add_contents(method.params, method.name, found);
  EXPECT_THAT(found, testing::ElementsAre("world.load.text", "world.import.files.data",
                                          "ask.contacts.text"));
}

// What is dropped names files of the same drop alone, however it asks for others.
TEST(WorldMethods, ADropNamesNothingElsewhere) {
  const std::string other = (fs::path(testing::TempDir()) / "thenar_secret").string();
  fs::create_directories(other);
  write_file(other + "/secret.obj", cube_obj());
  Client client("fence");
  const std::string climb = "../../../../../../../../../../..";
  for (const std::string& name :
       {other + "/secret.obj", climb + other + "/secret.obj", "file://" + other + "/secret.obj",
        std::string("package://thenar_secret/secret.obj"),
        "package://x/" + climb + other + "/secret.obj",
        std::string("../../thenar_secret/secret.obj"),
        std::string("model://thenar_secret/secret.obj")}) {
    std::string urdf = small_urdf();
    const std::string tip = "package://pack/meshes/tip.obj";
    for (std::size_t at = 0; (at = urdf.find(tip)) != std::string::npos;)
      urdf.replace(at, tip.size(), name);
    const OrderedJson added =
        client.ask("world.import", {{"files", {dropped("robot.urdf", urdf)}}, {"as", "hand"}});
    EXPECT_THAT(json_text(added["warnings"], -1), HasSubstr("MISSING MESH '" + name));
    EXPECT_THAT(json_text(added["warnings"], -1), testing::Not(HasSubstr("did you mean")));
    (void)client.ask("world.remove", {{"name", added["name"]}});
  }
  // Objects of ours and bodies of GraspIt!.
  const std::string toml =
      "name = 'x'\nsource = 'Mine'\n[sources]\nMine = 'x'\n[[shape]]\nkind = 'mesh'\nfile = '" +
      climb + other + "/secret.obj'\n";
  EXPECT_THAT(
      client.refusal("world.import", {{"files", {dropped("x.toml", toml)}}, {"as", "object"}}),
      HasSubstr("leads out of the folder that was dropped"));
  EXPECT_THAT(client.refusal("world.import",
                             {{"files",
                               {dropped("x.toml",
                                        "name = 'x'\nsource = 'Mine'\n[sources]\nMine = 'x'\n"
                                        "[[shape]]\nkind = 'mesh'\n"
                                        "file = \"x.stl\\u0000.obj\"\n")}},
                              {"as", "object"}}),
              HasSubstr("x.toml:7: "));
  const std::string xml =
      "<root><geometryFile type='obj'>" + climb + other + "/secret.obj</geometryFile></root>";
  EXPECT_THAT(
      client.refusal("world.import", {{"files", {dropped("x.xml", xml)}}, {"as", "object"}}),
      HasSubstr("leads out of the folder that was dropped"));
}

TEST(WorldMethods, LeaveHiddenFilesOfADropOut) {
  Client client("hidden");
  const OrderedJson added =
      client.ask("world.import", {{"files",
                                   {dropped(".DS_Store", "x"), dropped("r.urdf", small_urdf()),
                                    dropped("__MACOSX/._r.urdf", "x")}},
                                  {"as", "hand"}});
  EXPECT_THAT(json_text(added["warnings"], -1), HasSubstr("2 hidden files"));
}

// Methods that leave files behind say so, or a log of a stranger would write them.
// A job reads files and names. An edit between its start and its run is not seen by it, and it
// changes nothing of the world.
TEST(JobMethods, DoNotSeeTheLiveWorld) {
  Client client("jobs");
  client.session().jobs().defer();
  (void)client.ask("world.load", {{"world", "jaw_box"}});
  const Json request{{"world", "jaw_box"}};
  const int job =
      client.ask("job.start", {{"question", "grasp"}, {"request", request}})["job"].get<int>();
  (void)client.ask("world.remove", {{"name", "table"}});
  (void)client.ask("hand.grasp");
  const OrderedJson world = client.ask("world.get");
  (void)client.session().jobs().run_deferred(job, std::nullopt);
  EXPECT_EQ(client.ask("world.get"), world);
  const Answer alone = question_named("grasp").ask(request, kData, {});
  EXPECT_EQ(client.ask("job.result", {{"job", job}})["answer"], alone.json(UnitSystem::kSi));
}

TEST(WorldMethods, ThoseThatWriteFilesAreMarked) {
  const MethodTable table = method_table();
  for (const RpcMethod& method : table.methods()) {
    Client client("writes");
    (void)client.ask("world.load", {{"world", "jaw_box"}});
    try {
      (void)client.ask(method.name, Json::parse(method.example));
    } catch (const Error&) {
      continue;  // it wants something else to be open
    }
    EXPECT_EQ(fs::is_empty(client.folder()), method.writes == MethodWrites::kNothing)
        << method.name;
  }
}

TEST(WorldMethods, RefuseDropsThatLeadElsewhereOrAreNothing) {
  Client client("hostile");
  const std::string urdf = small_urdf();
  for (const char* name : {"../x.urdf", "/etc/x.urdf", "a/../../x.urdf", "", ".", "a\nb.urdf", "..",
                           "a/", "a\\b.urdf", ".git/x.urdf", "a/../b.urdf"})
    EXPECT_NE(client.refusal("world.import", {{"files", {dropped(name, urdf)}}, {"as", "hand"}}),
              "")
        << name;
  EXPECT_NE(client.refusal("world.import", {{"files", {dropped("x.txt", "")}}, {"as", "hand"}}),
            "");
  EXPECT_NE(
      client.refusal("world.import", {{"files", {dropped("x.obj", "f 1 2 3")}}, {"as", "object"}}),
      "");
  EXPECT_NE(client.refusal(
                "world.import",
                {{"files", {dropped("a.urdf", "<robot"), dropped("a.urdf", "x")}}, {"as", "hand"}}),
            "");
  EXPECT_NE(client.refusal("world.import",
                           {{"files", {{{"name", "x.obj"}, {"data", "!!!!"}}}}, {"as", "object"}}),
            "");
  EXPECT_NE(client.refusal("world.import", {{"files", Json::array()}, {"as", "object"}}), "");
  EXPECT_TRUE(client.ask("world.get")["hands"].empty());
  EXPECT_TRUE(fs::is_empty(client.folder()));
}

TEST(WorldRequests, Base64IsReadAsItIsWritten) {
  std::mt19937 random(3);
  for (std::size_t length = 0; length < 40; ++length) {
    std::string bytes;
    for (std::size_t i = 0; i < length; ++i) bytes += static_cast<char>(random());
    EXPECT_EQ(internal::from_base64(
                  base64(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size())),
              bytes);
  }
  EXPECT_EQ(internal::from_base64("TWFu"), "Man");  // RFC 4648's letters, by hand
  for (const char* wrong : {"TWF", "TW=u", "====", "TWF\n", "T===", "TWFu=", "TW\xC3\xA9"})
    EXPECT_THROW((void)internal::from_base64(wrong), InputError) << wrong;
}

// ---- hostile requests

Json draw_value(std::mt19937& random, int depth) {
  switch (random() % (depth > 0 ? 9U : 7U)) {
    case 0:
      return nullptr;
    case 1:
      return random() % 2 == 0;
    case 2:
      return static_cast<double>(random() % 2001) / 100 - 10;
    case 3:
      return 1e300;
    case 4:
      return std::string(random() % 400, 'x');
    case 5:
      return "barrett";
    case 6:
      return "../../etc/passwd";
    case 7: {
      Json list = Json::array();
      for (unsigned i = random() % 6; i-- > 0;) list.push_back(draw_value(random, depth - 1));
      return list;
    }
    default: {
      Json object = Json::object();
      for (const char* name : {"hand", "joints", "name", "position", "spread"})
        if (random() % 2 == 0) object[name] = draw_value(random, depth - 1);
      return object;
    }
  }
}

TEST(WorldMethods, HostileParamsAreRefusedOrHarmless) {
  Client client("random");
  (void)client.ask("world.load", {{"world", "barrett_bobbin"}});
  const MethodTable table = method_table();
  std::mt19937 random(11);
  int refused = 0, asked = 0;
  for (int round = 0; round < 60; ++round)
    for (const RpcMethod& method : table.methods()) {
      if (!is_ours(method.name)) continue;
      // The example with one member replaced, or one more.
      Json params = Json::parse(method.example);
      const auto& members = method.params.members;
      const std::string member =
          members.empty() || random() % 8 == 0 ? "other" : members[random() % members.size()].name;
      params[member] = draw_value(random, 3);
      refused += client.refusal(method.name, params).empty() ? 0 : 1;
      ++asked;
      ASSERT_NE(client.session().shown_model(), nullptr);
      check_instant(client.session().shown_model()->shape(),
                    client.session().shown_model()->instant());
    }
  EXPECT_GT(refused, asked / 2);
}

}  // namespace
}  // namespace thenar
