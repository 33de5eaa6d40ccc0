// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/appearance/currentappearance.h"
#include "editor/workspaces/appearance/texturework.h"

#include <QJsonObject>

namespace quadrille {

/// How a pair of textures is shown.
enum class TextureMode
{
    First,
    Second,
    Difference,
    AbsoluteDifference,
    SideBySide,
    Swipe,
};

/// What the texture view and the body show: of the frame that is looked at and what the user made of it. None
/// of it is part of the project.
class ShownTexture : public QObject
{
    Q_OBJECT

public:
    /// One of the two spaces of a model.
    enum class Space
    {
        Textures,
        Warps
    };
    /// A component of a model.
    struct Component
    {
        Space space = Space::Textures;
        int index = 0;

        bool operator==(const Component&) const = default;
    };

    explicit ShownTexture(CurrentAppearance& appearance, QObject* parent = nullptr);

    CurrentAppearance& appearance() const { return m_appearance; }

    TextureContent content() const { return m_content; }
    void setContent(TextureContent content);
    TextureMode mode() const { return m_mode; }
    void setMode(TextureMode mode);

    /// Components of both spaces of the model; 0 without one.
    int componentCount() const;
    /// How many are used, from the first on and of both spaces in their shares.
    int used() const;
    void setUsed(int components);
    /// Of one space of the model, and how many of them are used.
    int countOf(Space space) const;
    int usedOf(Space space) const;

    /// What the texture of the frame is made of, as far as it is used; none where the model does not know it.
    std::optional<AppearanceCoefficients> coefficients() const;
    /// A coefficient of it in standard deviations; 0 where there is none.
    double deviations(const Component& component) const;
    void setDeviations(const Component& component, double deviations);
    /// Whether the user changed some.
    bool isEdited() const { return m_edited.has_value(); }
    /// Back to the frame's own.
    void reset();
    /// To the mean texture.
    void toMean();
    /// Standard deviation along a component.
    double deviationOf(const Component& component) const;

    const Component& component() const { return m_component; }
    /// Shows it large.
    void showComponent(const Component& component);
    /// By how many standard deviations the two textures of a component lie from the mean.
    static constexpr double componentReach = 2;

    const std::optional<NamedFrame>& from() const { return m_from; }
    const std::optional<NamedFrame>& to() const { return m_to; }
    double weight() const { return m_weight; }
    /// The frames that the texture between is of.
    void setBetween(std::optional<NamedFrame> from, std::optional<NamedFrame> to);
    void setWeight(double weight);

    /// What is to be shown in the texture view; nothing where there is nothing to see.
    std::optional<TextureRequest> request() const;
    /// The sequence that the view shows, in textures as they are chosen here; between two frames in the pose
    /// between them as well.
    MeshSequence dressed(const MeshSequence& sequence) const;
    /// Why there is no second texture, in a sentence; empty where there is one.
    QString missing() const;

    /// For a session, and back.
    QJsonObject toJson() const;
    void fromJson(const QJsonObject& json);

signals:
    /// Something else is to be shown.
    void changed();
    /// `dressed` gives another sequence, for another reason than that another frame is looked at.
    void dressChanged();

private:
    const QuantisedSpace* space(Space space) const;
    std::optional<AppearanceCoefficients> own(const NamedFrame& frame) const;
    AppearanceCoefficients cut(AppearanceCoefficients coefficients) const;
    AppearanceCoefficients alongComponent(double deviations) const;
    Texture completed(const NamedFrame& frame) const;
    void requestBetween(TextureRequest& request) const;
    void follow();
    void tell();

    CurrentAppearance& m_appearance;
    TextureContent m_content = TextureContent::Frame;
    TextureMode m_mode = TextureMode::Second;
    std::optional<int> m_used; ///< all without
    std::optional<AppearanceCoefficients> m_edited;
    std::optional<NamedFrame> m_frame; ///< that the edited coefficients are of
    OpenedAppearancePointer m_opened;  ///< and the model
    Component m_component;
    std::optional<NamedFrame> m_from;
    std::optional<NamedFrame> m_to;
    double m_weight = 0.5;
};

} // namespace quadrille
