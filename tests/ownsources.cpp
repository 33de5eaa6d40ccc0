// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// A module of clang-tidy: its check quadrille-own-sources finds nothing, but keeps the other checks from
// searching what system headers declare (Qt, VTK, Eigen, the standard library), of which they would report
// nothing. With it a source takes less than a third of the time (see lint.py).
#include <clang-tidy/ClangTidyCheck.h>
#include <clang-tidy/ClangTidyModule.h>
#include <clang-tidy/ClangTidyModuleRegistry.h>
#include <clang/AST/ASTContext.h>
#include <clang/ASTMatchers/ASTMatchFinder.h>
#include <vector>

namespace {

class OwnSources : public clang::tidy::ClangTidyCheck
{
public:
    using ClangTidyCheck::ClangTidyCheck;

    void registerMatchers(clang::ast_matchers::MatchFinder* finder) override
    {
        finder->addMatcher(clang::ast_matchers::translationUnitDecl(), this);
    }

    /// Called for the whole unit before what is in it is searched, which asks for the scope only then.
    void check(const clang::ast_matchers::MatchFinder::MatchResult& result) override
    {
        std::vector<clang::Decl*> own;
        for (clang::Decl* declaration : result.Context->getTranslationUnitDecl()->decls())
            if (!result.SourceManager->isInSystemHeader(declaration->getLocation()))
                own.push_back(declaration);
        result.Context->setTraversalScope(own);
    }
};

class OwnSourcesModule : public clang::tidy::ClangTidyModule
{
public:
    void addCheckFactories(clang::tidy::ClangTidyCheckFactories& factories) override
    {
        factories.registerCheck<OwnSources>("quadrille-own-sources");
    }
};

const clang::tidy::ClangTidyModuleRegistry::Add<OwnSourcesModule> registered("quadrille",
                                                                             "What is ours alone.");

} // namespace
