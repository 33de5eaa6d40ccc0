// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/appearance/showntexture.h"

#include "editor/workspaces/appearance/betweenpose.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

std::vector<float>& valuesOf(AppearanceCoefficients& coefficients, ShownTexture::Space space)
{
    return space == ShownTexture::Space::Textures ? coefficients.textures : coefficients.warps;
}

QJsonObject frameJson(const std::optional<NamedFrame>& frame)
{
    if (!frame)
        return {};
    return {{"sequence", QString::fromStdString(frame->sequence)}, {"frame", qint64{frame->frame.value}}};
}

std::optional<NamedFrame> frameOf(const QJsonObject& json)
{
    const QString sequence = json["sequence"].toString();
    if (sequence.isEmpty())
        return std::nullopt;
    return NamedFrame{sequence.toStdString(), FrameIndex(std::max<qint64>(0, json["frame"].toInteger()))};
}

} // namespace

ShownTexture::ShownTexture(CurrentAppearance& appearance, QObject* parent)
    : QObject(parent), m_appearance(appearance)
{
    connect(&appearance, &CurrentAppearance::changed, this, &ShownTexture::changed);
    connect(&appearance, &CurrentAppearance::resultChanged, this, &ShownTexture::follow);
    connect(&appearance, &CurrentAppearance::frameChanged, this, &ShownTexture::follow);
}

/// What was made of one frame is not of another.
void ShownTexture::follow()
{
    const auto frame = m_appearance.frame();
    const auto opened = m_appearance.opened();
    const bool isOther = opened != m_opened || (frame != m_frame && m_edited);
    if (isOther)
        m_edited.reset();
    m_frame = frame;
    m_opened = opened;
    if (isOther)
        emit dressChanged();
    emit changed();
}

void ShownTexture::tell()
{
    emit dressChanged();
    emit changed();
}

void ShownTexture::setContent(TextureContent content)
{
    if (content == m_content)
        return;
    m_content = content;
    tell();
}

void ShownTexture::setMode(TextureMode mode)
{
    if (mode == m_mode)
        return;
    m_mode = mode;
    tell();
}

const QuantisedSpace* ShownTexture::space(Space space) const
{
    const auto opened = m_appearance.opened();
    if (opened == nullptr)
        return nullptr;
    const AppearanceModel& model = opened->decoder->model();
    return space == Space::Textures ? &model.textures : &model.warps;
}

int ShownTexture::countOf(Space space) const
{
    const QuantisedSpace* own = this->space(space);
    return own == nullptr ? 0 : static_cast<int>(own->count);
}

int ShownTexture::componentCount() const
{
    return countOf(Space::Textures) + countOf(Space::Warps);
}

int ShownTexture::used() const
{
    return std::min(m_used.value_or(componentCount()), componentCount());
}

void ShownTexture::setUsed(int components)
{
    const int before = used();
    m_used = components >= componentCount() ? std::nullopt : std::optional(std::max(0, components));
    if (used() != before)
        tell();
}

int ShownTexture::usedOf(Space space) const
{
    if (componentCount() == 0)
        return 0;
    const int textures = static_cast<int>(
        std::lround(static_cast<double>(used()) * countOf(Space::Textures) / componentCount()));
    return space == Space::Textures ? textures : used() - textures;
}

std::optional<AppearanceCoefficients> ShownTexture::own(const NamedFrame& frame) const
{
    const auto opened = m_appearance.opened();
    if (opened == nullptr)
        return std::nullopt;
    const auto found = opened->known.coefficients.find({frame.sequence, frame.frame});
    return found == opened->known.coefficients.end() ? std::nullopt : std::optional(found->second);
}

AppearanceCoefficients ShownTexture::cut(AppearanceCoefficients coefficients) const
{
    for (const Space space : {Space::Textures, Space::Warps}) {
        auto& values = valuesOf(coefficients, space);
        values.resize(std::min(values.size(), static_cast<std::size_t>(usedOf(space))));
    }
    return coefficients;
}

std::optional<AppearanceCoefficients> ShownTexture::coefficients() const
{
    if (m_edited)
        return cut(*m_edited);
    const auto frame = m_appearance.frame();
    auto known = frame ? own(*frame) : std::nullopt;
    return known ? std::optional(cut(std::move(*known))) : std::nullopt;
}

double ShownTexture::deviationOf(const Component& component) const
{
    const QuantisedSpace* own = space(component.space);
    const auto index = static_cast<std::size_t>(component.index);
    return own == nullptr || index >= own->eigenvalues.size()
               ? 0
               : std::sqrt(std::max(0.0, own->eigenvalues[index]));
}

double ShownTexture::deviations(const Component& component) const
{
    auto known = coefficients();
    const double deviation = deviationOf(component);
    const auto index = static_cast<std::size_t>(component.index);
    if (!known || deviation == 0 || index >= valuesOf(*known, component.space).size())
        return 0;
    return valuesOf(*known, component.space)[index] / deviation;
}

void ShownTexture::setDeviations(const Component& component, double deviations)
{
    if (!m_edited) {
        const auto frame = m_appearance.frame();
        m_edited = (frame ? own(*frame) : std::nullopt).value_or(AppearanceCoefficients());
        m_edited->textures.resize(static_cast<std::size_t>(countOf(Space::Textures)));
        m_edited->warps.resize(static_cast<std::size_t>(countOf(Space::Warps)));
    }
    auto& values = valuesOf(*m_edited, component.space);
    const auto index = static_cast<std::size_t>(component.index);
    if (index >= values.size())
        return;
    values[index] = static_cast<float>(deviations * deviationOf(component));
    m_content = TextureContent::Frame;
    if (m_mode == TextureMode::First) // what is made by hand is to be seen
        m_mode = TextureMode::Second;
    tell();
}

void ShownTexture::reset()
{
    m_edited.reset();
    tell();
}

void ShownTexture::toMean()
{
    m_edited = AppearanceCoefficients{std::vector<float>(static_cast<std::size_t>(countOf(Space::Textures))),
                                      std::vector<float>(static_cast<std::size_t>(countOf(Space::Warps)))};
    m_content = TextureContent::Frame;
    if (m_mode == TextureMode::First)
        m_mode = TextureMode::Second;
    tell();
}

void ShownTexture::showComponent(const Component& component)
{
    m_component = component;
    m_content = TextureContent::Component;
    tell();
}

AppearanceCoefficients ShownTexture::alongComponent(double deviations) const
{
    AppearanceCoefficients along;
    const int count = countOf(m_component.space);
    if (count == 0)
        return along;
    auto& values = valuesOf(along, m_component.space);
    const int index = std::min(m_component.index, count - 1);
    values.resize(static_cast<std::size_t>(index) + 1);
    values.back() = static_cast<float>(deviations * deviationOf({m_component.space, index}));
    return along;
}

void ShownTexture::setBetween(std::optional<NamedFrame> from, std::optional<NamedFrame> to)
{
    m_from = std::move(from);
    m_to = std::move(to);
    m_content = TextureContent::Between;
    tell();
}

void ShownTexture::setWeight(double weight)
{
    m_weight = std::clamp(weight, 0.0, 1.0);
    m_content = TextureContent::Between;
    tell();
}

Texture ShownTexture::completed(const NamedFrame& frame) const
{
    const auto opened = m_appearance.opened();
    const AppearanceEntry* entry = m_appearance.entry();
    const auto isIts = [&frame](const CompletionEntry& each) { return each.frame == frame; };
    if (opened == nullptr || entry == nullptr || std::ranges::none_of(entry->completions, isIts))
        return {};
    const auto found = opened->known.completed.find({frame.sequence, frame.frame});
    return found == opened->known.completed.end() ? Texture() : found->second;
}

void ShownTexture::requestBetween(TextureRequest& request) const
{
    const auto first = m_from ? own(*m_from) : std::nullopt;
    const auto second = m_to ? own(*m_to) : std::nullopt;
    request.captured = m_from ? m_appearance.textureOf(*m_from) : Texture();
    request.other = m_to ? m_appearance.textureOf(*m_to) : Texture();
    request.weight = m_weight;
    if (first && second) {
        request.first = *first;
        request.second = *second;
    } else {
        request.opened.reset();
    }
}

std::optional<TextureRequest> ShownTexture::request() const
{
    TextureRequest request;
    request.content = m_content;
    request.opened = m_appearance.opened();
    request.isSigned = m_mode != TextureMode::AbsoluteDifference;
    const auto frame = m_appearance.frame();
    switch (m_content) {
    case TextureContent::Component:
        if (componentCount() == 0)
            return std::nullopt;
        request.first = alongComponent(-componentReach);
        request.second = alongComponent(componentReach);
        request.isWarp = m_component.space == Space::Warps && countOf(Space::Warps) > 0;
        request.component =
            std::min(m_component.index, countOf(request.isWarp ? Space::Warps : Space::Textures) - 1);
        return request;
    case TextureContent::Between:
        requestBetween(request);
        return request.captured.isEmpty() && request.other.isEmpty() ? std::nullopt : std::optional(request);
    case TextureContent::Completed:
        if (!frame)
            return std::nullopt;
        request.captured = m_appearance.textureOf(*frame);
        request.other = completed(*frame);
        break;
    case TextureContent::Frame: {
        if (!frame)
            return std::nullopt;
        request.captured = m_appearance.textureOf(*frame);
        const auto known = coefficients();
        if (known)
            request.second = *known;
        else
            request.opened.reset();
        break;
    }
    }
    return request.captured.isEmpty() ? std::nullopt : std::optional(request);
}

QString ShownTexture::missing() const
{
    const auto frame = m_appearance.frame();
    if (m_appearance.opened() == nullptr)
        return tr("Build the model to see what it makes of this texture.");
    switch (m_content) {
    case TextureContent::Frame:
        return coefficients() || !frame
                   ? QString()
                   : tr("The model has not learned the texture of frame %1.").arg(frameText(*frame));
    case TextureContent::Completed:
        return !frame || !completed(*frame).isEmpty() ? QString()
                                                      : tr("Nothing of this texture is completed yet.");
    case TextureContent::Between:
        if (!m_from || !m_to)
            return tr("Choose the two frames in the panel Between.");
        return own(*m_from) && own(*m_to) ? QString() : tr("The model has not learned both frames.");
    case TextureContent::Component:
        break;
    }
    return {};
}

/// The loader of frames makes them, on threads of its own.
MeshSequence ShownTexture::dressed(const MeshSequence& sequence) const
{
    const auto wanted = request();
    const auto opened = m_appearance.opened();
    if (m_mode == TextureMode::First || opened == nullptr || !wanted || wanted->opened == nullptr ||
        sequence.textures.kind() != TextureSet::Kind::PerFrame)
        return sequence;
    std::vector<Texture> textures = sequence.textures.textures();
    const Texture chosen{.made = [request = *wanted] {
        const auto made = secondTexture(request);
        return made != nullptr ? *made : *firstTexture(request);
    }};
    const bool isOfAll = m_content == TextureContent::Between || m_content == TextureContent::Component;
    for (FrameIndex frame(0); frame.value < sequence.frameCount(); ++frame.value) {
        const auto place = static_cast<std::size_t>(sequence.sourceFrame(frame).value);
        if (place >= textures.size() || textures[place].isEmpty())
            continue;
        const NamedFrame named{sequence.name, frame};
        if (isOfAll || named == m_appearance.frame())
            textures[place] = chosen;
        else if (m_content == TextureContent::Completed && !completed(named).isEmpty())
            textures[place] = completed(named);
        else if (const auto known = m_content == TextureContent::Frame ? own(named) : std::nullopt)
            textures[place] = {.made = [opened, coefficients = cut(*known)] {
                return opened->decoder->decode(coefficients);
            }};
    }
    MeshSequence shown = sequence;
    shown.textures = TextureSet::perFrame(std::move(textures));
    if (m_content == TextureContent::Between)
        shown.source = betweenPose(sequence, m_appearance.sequenceOf(*m_from), m_from->frame,
                                   m_appearance.sequenceOf(*m_to), m_to->frame, m_weight);
    return shown;
}

QJsonObject ShownTexture::toJson() const
{
    QJsonObject json{{"content", static_cast<int>(m_content)},
                     {"mode", static_cast<int>(m_mode)},
                     {"space", static_cast<int>(m_component.space)},
                     {"component", m_component.index},
                     {"from", frameJson(m_from)},
                     {"to", frameJson(m_to)},
                     {"weight", m_weight}};
    if (m_used)
        json["used"] = *m_used;
    return json;
}

void ShownTexture::fromJson(const QJsonObject& json)
{
    const auto choice = [&json](const char* key, int last) {
        return std::clamp(json[QLatin1String(key)].toInt(), 0, last);
    };
    m_content = static_cast<TextureContent>(choice("content", static_cast<int>(TextureContent::Component)));
    m_mode = static_cast<TextureMode>(choice("mode", static_cast<int>(TextureMode::Swipe)));
    m_component = {static_cast<Space>(choice("space", 1)), std::max(0, json["component"].toInt())};
    m_from = frameOf(json["from"].toObject());
    m_to = frameOf(json["to"].toObject());
    m_weight = std::clamp(json["weight"].toDouble(0.5), 0.0, 1.0);
    m_used = json.contains("used") ? std::optional(std::max(0, json["used"].toInt())) : std::nullopt;
    tell();
}

} // namespace quadrille

#include "moc_showntexture.cpp"
