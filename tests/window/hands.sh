# Hands that xdotool does not have, on the real window: files dropped on it, a SpaceMouse, a pen.
# Read by window_test.sh, whose functions it uses.
dropFiles() {
  "$hands/drop_files" 500 400 "$@"
  local taken=$?
  sleep 1
  return $taken
}
# What a file manager drops: scenes, meshes, pictures, tools, anything else.
dropping() {
  local from="$work/Büsten & Köpfe 100%"
  mkdir -p "$from"
  cp "$work/scene.bzt" "$from/Äffchen zwei.bzt"
  cp "$work/scene.bzt" "$from/Horn.bzt"
  "$program" export "$work/scene.bzt" "$from/Würfel #1.stl"
  convert -size 64x64 gradient:red-blue "$from/Vorlage ö.png"
  echo text >"$from/notes.txt"
  openWindow "$work/drop.bzt"
  drag 500 400 580 420
  dropFiles "$from/notes.txt" && titled drop
  check $? "a dropped text is refused, the work stays"
  picture dropped_junk
  dropFiles "$from/Äffchen zwei.bzt" && titled drop
  check $? "a dropped scene asks about unsaved work"
  picture dropped_scene
  xdotool key Right
  sleep 0.3
  xdotool key Return
  titled "Äffchen zwei"
  check $? "and is opened"
  dropFiles "$from/Würfel #1.stl" && titled untitled
  check $? "a dropped mesh is imported"
  picture dropped_mesh
  dropFiles "$from/Vorlage ö.png" "$from/Vorlage ö.png"
  alive && titled untitled
  check $? "dropped pictures become references"
  picture dropped_pictures
  dropFiles "$from/Äffchen zwei.bzt"
  sleep 1
  xdotool key Right
  sleep 0.3
  xdotool key Return
  titled "Äffchen zwei"
  scene="$from/Äffchen zwei.bzt"
  xdotool key q
  sleep 2
  dropFiles "$from/Horn.bzt" "$from/Würfel #1.stl"
  sleep 4
  picture dropped_tools
  # Killed a moment after, and without a save.
  killWindow
  openWindow "$scene"
  xdotool key q
  sleep 3
  picture dropped_tools_recovered
  savedMass >/dev/null
  printf '%s\n' '{"bozzetto":"recording","version":1}' \
    '{"op":"tool","shape":"freeform","from":"shelf:Horn"}' '{"op":"stroke","points":[[60,0,0]]}' \
    '{"op":"tool","shape":"freeform","from":"shelf:Würfel #1"}' >"$work/tools.jsonl"
  "$program" replay "$work/tools.jsonl" --from "$scene" -o "$work/with_tools.bzt"
  check $? "tools that were dropped on the shelf survive a kill"
  closeWindow
}

# Whether two pictures differ in more than specks.
differs() {
  local pixels
  pixels=$(compare -metric AE "$out/$1.png" "$out/$2.png" null: 2>&1)
  ((${pixels%%.*} > 20000))
}
# A SpaceMouse whose daemon is ours: it turns what is seen, and its button goes back.
puck() {
  export SPNAV_SOCKET="$work/spnav"
  mkfifo "$work/puck"
  "$hands/fake_puck" "$SPNAV_SOCKET" <"$work/puck" &
  puck_pid=$!
  exec 4>"$work/puck"
  sleep 0.5
  drawn="$work/drawn.bzt"
  cp "$work/ball.bzt" "$drawn"
  openWindow "$drawn"
  drag 500 400 560 380  # something that shows how the ball is turned
  sleep 3
  picture puck_before
  for _ in {1..12}; do echo "move 0 0 0 0 300 0 100" >&4; done
  sleep 3
  picture puck_turned
  differs puck_before puck_turned
  check $? "a SpaceMouse turns the scene"
  exec 4>&-
  sleep 1
  alive
  check $? "and may go away"
  unset SPNAV_SOCKET
  killWindow
}

# A pen with pressure: Xvfb has none, Xorg's driver inputtest(4) is one.
startPenServer() {
  local size=1280x800
  cat >"$work/xorg.conf" <<END
Section "ServerFlags"
  Option "AutoAddDevices" "false"
EndSection
Section "InputDevice"
  Identifier "Pen"
  Driver "inputtest"
  Option "SocketPath" "$work/pen"
  Option "DeviceType" "PointerAbsoluteProximity"
  Option "PointerHasPressure" "true"
EndSection
Section "Device"
  Identifier "Card"
  Driver "dummy"
  VideoRam 65536
EndSection
Section "Monitor"
  Identifier "Monitor"
  HorizSync 10-100
  VertRefresh 10-100
  Modeline "$size" 83.5 1280 1352 1480 1680 800 803 809 831
EndSection
Section "Screen"
  Identifier "Screen"
  Device "Card"
  Monitor "Monitor"
  DefaultDepth 24
  SubSection "Display"
    Modes "$size"
    Virtual ${size/x/ }
  EndSubSection
EndSection
Section "ServerLayout"
  Identifier "Layout"
  Screen "Screen"
  InputDevice "Pen" "SendCoreEvents"
EndSection
END
  Xorg -displayfd 3 -noreset -nolisten tcp -config "$work/xorg.conf" -logfile "$out/xorg.log" \
    3>"$work/pen_display" 2>"$out/xorg.err" &
  pen_server_pid=$!
  local n
  for n in {1..100}; do
    [[ -s $work/pen_display && -S $work/pen ]] && return 0
    sleep 0.1
  done
  return 1
}
# penStroke PRESSURE: until it is in the journal.
penStroke() {
  local n done
  done=$(steps "$scene.history")
  {
    echo near
    echo "move 500 400 0"
    echo "wait 500"
    echo "move 500 400 $1"
    echo down
    for n in {1..12}; do echo "move $((500 + 5 * n)) $((400 + n)) $1" && echo "wait 20"; done
    echo up
    echo "move 570 412 0"
    echo away
  } >&4
  journalled "$scene.history" $((done + 1))
}
pen() {
  local screen=$DISPLAY m0 soft hard
  if ! startPenServer; then  # it wants a console, which not every machine has
    echo "window: skipped: a pen, for want of an X server with one ($out/xorg.log)"
    return
  fi
  DISPLAY=":$(tr -d '\n' <"$work/pen_display")"
  scene="$work/pen.bzt"
  cp "$work/ball.bzt" "$scene"
  openWindow "$scene"
  # One for all strokes: the driver listens to nobody twice.
  mkfifo "$work/strokes"
  "$hands/fake_pen" "$work/pen" 1280 800 <"$work/strokes" &
  pen_pid=$!
  exec 4>"$work/strokes"
  m0=$(massOf "$scene")
  penStroke 0.25
  picture pen_soft
  soft=$(savedMass)
  xdotool key ctrl+z
  sleep 1
  savedMass >/dev/null
  penStroke 1
  picture pen_hard
  hard=$(savedMass)
  awk -v m="$m0" -v s="$soft" -v h="$hard" 'BEGIN {
    exit !(s > m * (1 + 1e-6) && s - m < 0.6 * (h - m))
  }'
  check $? "a light pen adds less than a heavy one ($m0: $soft, $hard)"
  exec 4>&-
  closeWindow
  DISPLAY=$screen
}
