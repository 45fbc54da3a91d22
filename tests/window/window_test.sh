#!/usr/bin/env bash
# The real window under Xvfb, driven like a person would: tests/window/window_test.sh PROGRAM
#   [SECONDS of random input, 60] [SEED of it, 7]
# Beside PROGRAM lie the hands that xdotool does not have (target window_hands).
# Prints a line per check; the last one counts them. Pictures stay in build/window.
set -uo pipefail
program=$(readlink -f "$1")
seconds=${2:-60}
seed=${3:-7}
hands=$(dirname "$program")
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
out="$root/build/window"
passed=0 failed=0
mkdir -p "$out"
work=$(mktemp -d)
export XDG_CONFIG_HOME="$work/config" XDG_STATE_HOME="$work/state"

finish() {
  local pid
  for pid in ${window_pid:-} ${puck_pid:-} ${pen_pid:-} ${server_pid:-} ${pen_server_pid:-}; do
    kill "$pid" 2>/dev/null
  done
  rm -rf "$work"
}
trap finish EXIT

check() {
  if [[ $1 == 0 ]]; then
    passed=$((passed + 1))
    echo "window: ok: $2"
  else
    failed=$((failed + 1))
    echo "window: FAILED: $2"
    picture "failed_$failed"
  fi
}
picture() { import -window root "$out/$1.png" 2>/dev/null; }

startServer() {
  Xvfb -displayfd 3 -screen 0 "${1:-1280x800}x24" -nolisten tcp \
    3>"$work/display" 2>"$out/xvfb.log" &
  server_pid=$!
  local n
  for n in {1..100}; do
    [[ -s $work/display ]] && break
    sleep 0.1
  done
  DISPLAY=":$(tr -d '\n' <"$work/display")"
  export DISPLAY
}

# Opens the window and waits until it shows clay.
openWindow() {
  "$program" "$@" 2>"$out/program.log" &
  window_pid=$!
  window=$(timeout 60 xdotool search --sync --onlyvisible --class bozzetto | head -n 1)
  local n
  for n in {1..100}; do
    (($(colours 500x400+200+200) > 40)) && return 0
    sleep 0.3
  done
  return 1
}
closeWindow() {
  xdotool key ctrl+q
  local n
  for n in {1..150}; do
    kill -0 "$window_pid" 2>/dev/null || return 0
    sleep 0.2
  done
  return 1
}
alive() {
  kill -0 "$window_pid" 2>/dev/null && return 0
  cat "$out/program.log"
  return 1
}

# How many colours a part of the screen has.
colours() { import -window root -crop "$1" -format %k info: 2>/dev/null || echo 0; }

move() { xdotool mousemove "$1" "$2"; }
# drag X Y X Y [BUTTON]
drag() {
  local n button=${5:-1}
  move "$1" "$2"
  sleep 0.15
  xdotool mousedown "$button"
  sleep 0.1
  for n in {1..12}; do
    move $(($1 + ($3 - $1) * n / 12)) $(($2 + ($4 - $2) * n / 12))
    sleep 0.02
  done
  sleep 0.1
  xdotool mouseup "$button"
  sleep 0.3
}

stampOf() { stat -c %y%s "$1" 2>/dev/null || echo none; }
# Waits until the title has this in it.
titled() {
  local n
  for n in {1..120}; do
    [[ $(xdotool getwindowname "$window") == *"$1"* ]] && return 0
    sleep 0.25
  done
  echo "title: $(xdotool getwindowname "$window")"
  return 1
}
steps() { find "$1" -name '*.undo' 2>/dev/null | wc -l; }
# Waits until there are that many undo-files in a folder.
journalled() {
  local n
  for n in {1..120}; do
    (($(steps "$1") >= $2)) && return 0
    sleep 0.25
  done
  return 1
}

# Saves with Ctrl+S, waits for the file, prints its mass.
savedMass() {
  local before n
  before=$(stampOf "$scene")
  xdotool key ctrl+s
  for n in {1..80}; do
    [[ $(stampOf "$scene") != "$before" ]] && break
    sleep 0.25
  done
  for n in {1..80}; do
    before=$(stampOf "$scene")
    sleep 0.5
    [[ $(stampOf "$scene") == "$before" && ! -e $scene-journal ]] && break
  done
  "$program" info "$scene" --json | grep -o '"mass": *[-0-9.e+]*' | head -n 1 | tr -dc '0-9.e+-'
}
isMore() { awk -v a="$1" -v b="$2" 'BEGIN {exit !(a > b + 1e-9 * b)}'; }
isSame() { awk -v a="$1" -v b="$2" 'BEGIN {d = a - b; if (d < 0) d = -d; exit !(d <= 1e-9 * b)}'; }

sculpt() {
  local m0 m1 m2 m3
  m0=$("$program" info "$scene" --json | grep -o '"mass": *[-0-9.e+]*' | head -n 1 |
    tr -dc '0-9.e+-')
  drag 520 400 580 420
  picture added
  m1=$(savedMass)
  isMore "$m1" "$m0"
  check $? "a left drag on the clay adds clay ($m0 to $m1), Ctrl+S saves it"
  xdotool keydown ctrl
  drag 500 440 560 440
  xdotool keyup ctrl
  m2=$(savedMass)
  isMore "$m1" "$m2"
  check $? "with Ctrl it carves ($m2)"
  xdotool key ctrl+z
  sleep 0.5
  m3=$(savedMass)
  isSame "$m3" "$m1"
  check $? "Ctrl+Z takes it back ($m3)"
  xdotool key ctrl+shift+z
  sleep 0.5
  isSame "$(savedMass)" "$m2"
  check $? "Ctrl+Shift+Z does it again"
  drag 110 300 150 380
  isMore "$(savedMass)" "$m2"
  check $? "clay can be made in empty air"
  xdotool keydown shift
  drag 500 400 570 400
  xdotool keyup shift
  alive
  check $? "Shift smooths"
}

look() {
  drag 520 400 640 360 2
  move 520 400
  xdotool click 4
  xdotool click 5
  for key in KP_End KP_Next KP_Home KP_Begin Home w n b; do
    xdotool key "$key"
    sleep 0.3
  done
  picture looks
  alive
  check $? "orbit, zoom, axis views, looks"
}

files() {
  local other="$work/other name.bzt"
  xdotool key ctrl+shift+s
  sleep 1.5
  picture save_as
  xdotool key ctrl+a
  xdotool type --delay 30 "$other"
  sleep 0.5
  xdotool key Return
  local n
  for n in {1..60}; do
    [[ -s $other ]] && break
    sleep 0.25
  done
  [[ -s $other ]]
  check $? "the file dialog saves by keyboard alone"
  sleep 1
  xdotool key F1
  sleep 1
  picture help
  xdotool key Escape
  sleep 0.5
  xdotool key space
  sleep 0.7
  picture palette
  xdotool key Escape
  closeWindow
  check $? "Ctrl+Q closes a saved scene at once"
  openWindow "$other"
  check $? "the saved scene opens again"
  picture reopened
}

massOf() {
  "$program" info "$1" --json | grep -o '"mass": *[-0-9.e+]*' | head -n 1 | tr -dc '0-9.e+-'
}
killWindow() {
  kill -9 "$window_pid"
  wait "$window_pid" 2>/dev/null
}

# The window is killed after strokes that were not saved; all of it is there again.
recovery() {
  local killed="$work/killed.bzt" before after
  cp "$work/scene.bzt" "$killed"
  killWindow  # it may well be asking whether to save
  rm -rf "$XDG_CONFIG_HOME"  # random input may well have given Ctrl+S another meaning
  openWindow "$killed"
  drag 500 400 580 420
  drag 500 440 560 470
  journalled "$killed.history" 2
  killWindow
  before=$(massOf "$killed")
  openWindow "$killed"
  titled '*'
  sleep 1
  picture recovered
  xdotool key Return
  sleep 1
  xdotool key shift+Tab
  sleep 1
  picture history
  xdotool key shift+Tab
  scene=$killed
  after=$(savedMass)
  isMore "$after" "$before"
  check $? "after kill -9 the strokes are there ($before to $after)"
  xdotool key ctrl+z
  xdotool key ctrl+z
  sleep 0.7
  isSame "$(savedMass)" "$before"
  check $? "and can be undone"
  closeWindow
  check $? "a recovered scene that is saved closes at once"
}

# The same without a name.
leftBehind() {
  local state="$XDG_STATE_HOME/bozzetto" before
  before=$(steps "$state")
  openWindow
  drag 500 400 580 420
  journalled "$state" $((before + 2))
  killWindow
  openWindow
  sleep 2
  picture left_behind
  xdotool key Escape
  sleep 0.5
  alive
  check $? "work without a name is offered again"
  closeWindow
  check $? "later is an answer too"
}

resize() {
  xdotool windowsize --sync "$window" 900 640
  sleep 1
  picture resized
  drag 400 320 440 330
  alive
  check $? "goes on after a resize"
  xdotool windowsize --sync "$window" 1280 800
  sleep 0.5
}

# Anything but quitting, at any place.
randomInput() {
  local keys=(x f s 1 2 3 4 5 6 7 8 9 0 w n b t Tab space Escape ctrl+z ctrl+y bracketleft
    bracketright KP_End KP_Next KP_Begin KP_Home Home shift+f ctrl+f F1 ctrl+o ctrl+s e shift+x
    F3 F2 Return F11 Escape)
  local end=$((SECONDS + seconds))
  RANDOM=$seed
  while ((SECONDS < end)) && alive; do
    case $((RANDOM % 4)) in
      0) xdotool key "${keys[RANDOM % ${#keys[@]}]}" ;;
      1) move $((RANDOM % 1280)) $((RANDOM % 800)) && xdotool click $((1 + RANDOM % 5)) ;;
      *)
        local x=$((100 + RANDOM % 850)) y=$((60 + RANDOM % 680)) button=$((1 + RANDOM % 3))
        xdotool mousemove $x $y mousedown $button
        xdotool mousemove_relative -- $((RANDOM % 160 - 80)) $((RANDOM % 160 - 80))
        xdotool mousemove_relative -- $((RANDOM % 160 - 80)) $((RANDOM % 160 - 80))
        xdotool mouseup $button
        ;;
    esac
    sleep 0.03
  done
  sleep 2
  picture random
  alive
  check $? "$seconds s of random input without a crash"
  local kilobytes
  kilobytes=$(awk '/VmRSS/ {print $2}' "/proc/$window_pid/status" 2>/dev/null || echo 9999999)
  ((kilobytes < 2000000))
  check $? "memory stays bounded ($((kilobytes / 1000)) MB)"
}

source "$root/tests/window/hands.sh"
startServer 1280x800
scene="$work/scene.bzt"
printf '%s\n' '{"bozzetto":"recording","version":1}' \
  '{"op":"fill","shape":"ellipsoid","center":[0,0,0],"radii":[48,48,48]}' >"$work/ball.jsonl"
"$program" replay "$work/ball.jsonl" -o "$scene"
cp "$scene" "$work/ball.bzt"
openWindow "$scene"
check $? "the window opens and shows the scene"
picture opened
geometry=$(xdotool getwindowgeometry --shell "$window" |
  grep -E '^(X|Y|WIDTH|HEIGHT)=' | tr '\n' ' ')
[[ $geometry == "X=0 Y=0 WIDTH=1280 HEIGHT=800 " ]]
check $? "1280x800 at the top left corner ($geometry)"
sculpt
look
files
resize
randomInput
scene="$work/scene.bzt"
recovery
leftBehind
dropping
puck
pen
echo "window: $passed passed, $failed failed"
((failed == 0))
