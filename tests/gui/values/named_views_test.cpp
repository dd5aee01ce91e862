#include "ui/document/named_views.h"

#include <QTemporaryDir>
#include <gtest/gtest.h>

namespace knittsim::document {
namespace {

class NamedViewsTest : public ::testing::Test {
protected:
    void SetUp() override { qputenv("KNITTSIM_CONFIG_DIR", folder.path().toUtf8()); }
    void TearDown() override { qunsetenv("KNITTSIM_CONFIG_DIR"); }

    static std::vector<QString> names(const NamedViews& views) {
        std::vector<QString> names;
        for (const NamedView& view : views.views()) {
            names.push_back(view.name);
        }
        return names;
    }

    QTemporaryDir folder;
};

TEST_F(NamedViewsTest, AreRememberedForEachFile) {
    {
        Session session;
        NamedViews views(session);
        views.setFile("/a/first.k");
        EXPECT_TRUE(views.save(" Edge ", "camera 1"));
        EXPECT_TRUE(views.save("Neck", "camera 2"));
        EXPECT_TRUE(views.save("Edge", "camera 3")); // the same once more
    }
    Session session;
    NamedViews views(session);
    views.setFile("/a/second.k");
    EXPECT_TRUE(views.views().empty());
    views.setFile("/a/first.k");
    EXPECT_EQ(names(views), (std::vector<QString>{"Edge", "Neck"}));
    EXPECT_EQ(views.find("Edge")->camera, "camera 3");
}

TEST_F(NamedViewsTest, NamesAreNeitherEmptyNorTaken) {
    Session session;
    NamedViews views(session);
    EXPECT_FALSE(views.save("no file", "camera"));
    views.setFile("/a/first.k");
    EXPECT_FALSE(views.save("  ", "camera"));
    views.save("one", "camera 1");
    views.save("two", "camera 2");
    EXPECT_FALSE(views.rename("one", "two"));
    EXPECT_FALSE(views.rename("one", ""));
    EXPECT_FALSE(views.rename("three", "four"));
    EXPECT_TRUE(views.rename("one", "three"));
    views.remove("two");
    EXPECT_EQ(names(views), std::vector<QString>{"three"});
}

TEST_F(NamedViewsTest, ForeignBytesAreNoViews) {
    Session session;
    NamedViews views(session);
    views.setFile("/a/first.k");
    views.save("one", QByteArray(4000, 'x'));
    const QStringList keys = QSettings(Session::filePath(), QSettings::IniFormat).allKeys();
    QString key;
    for (const QString& each : keys) {
        if (each.startsWith("views/")) {
            key = each;
        }
    }
    ASSERT_FALSE(key.isEmpty());
    const QByteArray whole = session.value(key);
    session.setValue(key, whole.left(whole.size() / 2));
    views.setFile("/a/first.k");
    EXPECT_TRUE(views.views().empty());
    session.setValue(key, "nonsense");
    views.setFile("/a/first.k");
    EXPECT_TRUE(views.views().empty());
}

} // namespace
} // namespace knittsim::document
