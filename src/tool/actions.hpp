// One file an action; here their makers.
#pragma once
#include "bozzetto/tool/action.hpp"

namespace bozzetto {

std::unique_ptr<Action> makeAdd(Colour colour);
std::unique_ptr<Action> makeRemove();
std::unique_ptr<Action> makeErase(ToolBody body);
std::unique_ptr<Action> makePaint(Colour colour);
std::unique_ptr<Action> makePaintSoft(Colour colour);
std::unique_ptr<Action> makeSmooth();
std::unique_ptr<Action> makeStamp(StampProfile profile, double iso, ToolBody body);
/// Add, paint or paintSoft.
std::unique_ptr<Action> makeOwnColours(ActionKind kind);
std::unique_ptr<Action> makeHold();
std::unique_ptr<Action> makeFree();
std::unique_ptr<Action> makeStiffen();
std::unique_ptr<Action> makeSoften();

}  // namespace bozzetto
