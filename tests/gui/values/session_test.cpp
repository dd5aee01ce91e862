#include "ui/document/session.h"

#include <QFileInfo>
#include <QTemporaryDir>
#include <gtest/gtest.h>

namespace knittsim::document {
namespace {

class SessionTest : public ::testing::Test {
protected:
    void SetUp() override { qputenv("KNITTSIM_CONFIG_DIR", folder.path().toUtf8()); }
    void TearDown() override { qunsetenv("KNITTSIM_CONFIG_DIR"); }

    QTemporaryDir folder;
};

TEST_F(SessionTest, IsRememberedInTheFolderThatTheEnvironmentNames) {
    {
        Session session;
        session.addRecentFile(QStringLiteral("/a/first.k"));
        session.setAppearance(Appearance::Dark);
        session.setLastFolder(QStringLiteral("/a"));
    }
    EXPECT_TRUE(QFileInfo::exists(folder.filePath(QStringLiteral("knittsim.ini"))));
    const Session again;
    EXPECT_EQ(again.recentFiles(), QStringList{QStringLiteral("/a/first.k")});
    EXPECT_EQ(again.appearance(), Appearance::Dark);
    EXPECT_EQ(again.lastFolder(), QStringLiteral("/a"));
}

TEST_F(SessionTest, TenRecentFilesTheNewestFirstEachOnce) {
    Session session;
    for (int i = 0; i < 14; ++i) {
        session.addRecentFile(QStringLiteral("/a/%1.k").arg(i));
    }
    session.addRecentFile(QStringLiteral("/a/9.k"));
    const QStringList files = session.recentFiles();
    EXPECT_EQ(files.size(), Session::kMaxRecentFiles);
    EXPECT_EQ(files.front(), QStringLiteral("/a/9.k"));
    EXPECT_EQ(files.count(QStringLiteral("/a/9.k")), 1);
    EXPECT_EQ(files.back(), QStringLiteral("/a/4.k"));
}

TEST_F(SessionTest, ClearForgetsEverything) {
    Session session;
    session.addRecentFile(QStringLiteral("/a/first.k"));
    session.clear();
    EXPECT_TRUE(Session().recentFiles().isEmpty());
}

} // namespace
} // namespace knittsim::document
