"""Tests mistakes that newcomers make: each answer names the mistake and the remedy in full, in at most three
lines of 100 columns.

Usage: mistakes_check.py RAYTRACER, from the source folder.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from checks import RAYTRACER, check, check_width, conclude, failures

SCENE = """{
    "camera": {
        "type": "perspective", "focal_length": 1, "eye": [0, 0, 4], "look": [0, 0, -1], "up": [0, 1, 0],
        "film_left": -0.5, "film_right": 0.5, "film_bottom": -0.5, "film_top": 0.5
    },
    "textures": { "wood": "textures/wood.png" },
    "materials": [
        { "name": "red", "color_diffuse": [0.8, 0.1, 0.1], "shininess": 40 },
        { "name": "floor", "use_diffuse_texture": true, "diffuse_texture": "wood" }
    ],
    "lights": [ { "position": [3, 5, 4], "color": [1, 1, 1] } ],
    "transforms": [ { "name": "ball" }, { "name": "floor", "translate": [0, -1, 0] } ],
    "shapes": [
        { "type": "sphere", "transform": "ball", "material": "red" },
        { "type": "cube", "transform": "floor", "material": "floor" }
    ]
}
"""
RENDER = ["scene.json", "out.png", "8"]
ORDER = "the order is SCENE IMAGE_OUT LONG_EDGE_PIXELS"
NO_USER = "only root may run programs as another user" if os.geteuid() else "there is no user nobodyhere"
SCENE_ON_STDIN = "raytracer: a scene is not read from standard input: name its file"

# What is typed, and what is answered: an error.
COMMANDS = [
    ("", f"raytracer: SCENE is missing; {ORDER} (see --help)"),
    ("render scene.json out.png 8",
     'raytracer: unknown command "render"; write raytracer SCENE IMAGE_OUT LONG_EDGE_PIXELS'),
    ("comapre a.png b.png", 'raytracer: unknown command "comapre"; did you mean "compare"?'),
    ("explain scene.json 3 3 20 --dept 2", "raytracer explain: unknown option --dept; did you mean --depth?"),
    ("explain scene.json 3 3 20 --depht 2",
     "raytracer explain: unknown option --depht; did you mean --depth?"),
    ("explain scene.json 3 3 20 --bounce 2",
     "raytracer explain: unknown option --bounce; did you mean --max-recursion?"),
    ("scene.json out.png 8 --max-depth 2",
     "raytracer: unknown option --max-depth; did you mean --max-recursion?"),
    ("tradeoff scene.json --thread 2",
     "raytracer tradeoff: unknown option --thread; did you mean --threads?"),
    ("trade scene.json", 'raytracer: unknown command "trade"; did you mean "tradeoff"?'),
    ("expl scene.json 3 3 20", 'raytracer: unknown command "expl"; did you mean "explain"?'),
    ("grad scenes", 'raytracer: unknown command "grad"; did you mean "grade"?'),
    ("--print-completion", "raytracer: --print-completion: expected bash, zsh or fish, found nothing"),
    ("--print-completion tcsh", 'raytracer: --print-completion: expected bash, zsh or fish, found "tcsh"'),
    ("--print-completion=tcsh", 'raytracer: --print-completion: expected bash, zsh or fish, found "tcsh"'),
    ("--print-completion bash zsh", "raytracer: --print-completion bash stands alone"),
    ("--print-completion --quiet",
     'raytracer: --print-completion: expected bash, zsh or fish, found "--quiet"'),
    ("scene.json --print-completion zsh", "raytracer: --print-completion zsh stands alone"),
    ("--print-manual foo", "raytracer: --print-manual stands alone"),
    ("--print-schema o.json", "raytracer: --print-schema stands alone"),
    ("--print-schema --quiet", "raytracer: --print-schema stands alone"),
    ("--quiet --print-schema", "raytracer: --print-schema stands alone"),
    ("--print-manual=1", 'raytracer: --print-manual: expected no value, found "1"'),
    ("out.png scene.json 8",
     "raytracer: is out.png the picture? The order is SCENE IMAGE_OUT LONG_EDGE_PIXELS"),
    ("scene.json 8", f"raytracer: IMAGE_OUT is missing; {ORDER} (see --help)"),
    ("scene.json out.png", f"raytracer: LONG_EDGE_PIXELS is missing; {ORDER} (see --help)"),
    ("scene.json out.png 8 6", f'raytracer: unexpected argument "6"; {ORDER}'),
    ("scene.json out.png 8x6",
     'raytracer: LONG_EDGE_PIXELS: expected a whole number from 1 to 65536, found "8x6"'),
    ("scene.json -o out.png 8", f"raytracer: unknown option -o; {ORDER}"),
    ("scene.json out.png 8 --sample 4", "raytracer: unknown option --sample; did you mean --samples?"),
    ("scene.json out.png 8 --recursion 4",
     "raytracer: unknown option --recursion; did you mean --max-recursion?"),
    ("scene.json out.png 8 --samples",
     "raytracer: --samples: expected a whole number from 1 to 65536, found nothing"),
    ("scene.json out.png 8 --only difuse", 'raytracer: --only: no term "difuse"; did you mean "diffuse"?'),
    ("scene.json out.png 8 --pass normal",
     'raytracer: --pass: expected color, raycast or normals, found "normal"; did you mean "normals"?'),
    ("scene.json out.png 8 --texture-filter trilinear",
     'raytracer: --texture-filter: expected nearest or bilinear, found "trilinear"'),
    ("explain scene.json 3 3 8 --precision doubble",
     'raytracer explain: --precision: expected float, double or extended, found "doubble"'),
    ("scene.json out.png 8 --pass normals --only diffuse",
     "raytracer: --only has no effect with --pass normals"),
    ("scene.json out.png 8 --only diffuse --max-recursion 9",
     "raytracer: --max-recursion has no effect with --only diffuse"),
    ("explain scene.json 3 3 8 --only diffuse,shadows --max-recursion 9",
     "raytracer explain: --max-recursion has no effect with --only diffuse,shadows"),
    ("scene.json out.png 8 --target-error 1 --samples 4",
     "raytracer: --target-error and --samples exclude each other: give one of them"),
    ("scene.json out.png 8 --crop 0,0,9,9",
     'raytracer: --crop: expected a rectangle inside of the 8 x 8 picture, found "0,0,9,9"'),
    ("scene.json out.jpg 8", "out.jpg: expected a name that ends in .png or .pfm"),
    ("scene.json nowhere/out.png 8",
     'nowhere/out.png: cannot write: No such file or directory; there is no folder "nowhere"'),
    ("explain scene.json 8 8 8",
     "raytracer explain: expected X from 0 to 7 and Y from 0 to 7, found 8 and 8"),
    ("scene.json out.png 8 --crop 0,0,99999999999,9",
     'raytracer: --crop: expected a rectangle inside of the 8 x 8 picture, found "0,0,99999999999,9"'),
    ("compare out.png out.png --max-pixels 99999999999999999999",
     'raytracer compare: --max-pixels: expected at most 18446744073709551615, found "99999999999999999999"'),
    ("explain scene.json -2147483649 0 8",
     'raytracer explain: X: expected at least -2147483648, found "-2147483649"'),
    ("compare out.png out.png --max-pixels -99999999999999999999",
     "raytracer compare: --max-pixels: expected a whole number not below 0, found "
     '"-99999999999999999999"'),
    ("scene.json out.png 8 --crop 4,4,2,2",
     'raytracer: --crop: expected x0,y0,x1,y1 with x0 < x1 and y0 < y1, found "4,4,2,2"'),
    ("compare a.png b.png c.png", 'raytracer compare: unexpected argument "c.png"; the order is A B'),
    ("scene.json other.json out.png 8", f'raytracer: unexpected argument "other.json"; {ORDER}'),
    ("scene.json out.png b.png 8", f'raytracer: unexpected argument "b.png"; {ORDER}'),
    ("scene.json out.png 8 b.png", f'raytracer: unexpected argument "b.png"; {ORDER}'),
    ("explain scene.json scene.json 3 3 8",
     'raytracer explain: unexpected argument "scene.json"; the order is SCENE X Y LONG_EDGE_PIXELS'),
    ("out.png compare reference.png", "raytracer: the command stands first: raytracer compare ..."),
    ("scene.json explain 3 3 8", "raytracer: the command stands first: raytracer explain ..."),
    ("explain scene.json 3,3 8", 'raytracer explain: X: expected a whole number, found "3,3"; write 3 3'),
    ("explain scene.json 3 3x8", 'raytracer explain: Y: expected a whole number, found "3x8"'),
    ("scene.json out.png 8 --crop 0 0 5 5", "raytracer: --crop has commas, no blanks: write --crop 0,0,5,5"),
    ("--crop 0 0 5 5 scene.json out.png 8", "raytracer: --crop has commas, no blanks: write --crop 0,0,5,5"),
    ("scene.json out.png --crop 0, 0, 5, 5 8",
     "raytracer: --crop has commas, no blanks: write --crop 0,0,5,5"),
    ("scene.json out.png --crop 0,0,5,5 8 9", f'raytracer: unexpected argument "9"; {ORDER}'),
    ("scene.json out.png 8 --set /camera/eye 1,2,3",
     'raytracer: --set takes /pointer=value: write --set "/camera/eye=[1,2,3]"'),
    ("--set /materials/0/shininess 9 scene.json out.png 8",
     'raytracer: --set takes /pointer=value: write --set "/materials/0/shininess=9"'),
    ("scene.json out.png 8 --set /camera/eye = [1,2,3]",
     'raytracer: --set takes /pointer=value: write --set "/camera/eye=[1,2,3]"'),
    ("scene.json out.png 8 --set /camera/eye= [1, 2, 3]",
     'raytracer: --set takes /pointer=value: write --set "/camera/eye=[1, 2, 3]"'),
    ("scene.json out.png 8 --set /camera/eye=[1, 2, 3]",
     'raytracer: --set takes /pointer=value: write --set "/camera/eye=[1, 2, 3]"'),
    ('scene.json out.png 8 --set /lights/-={"position": [1,2,3]}',
     """raytracer: --set takes /pointer=value: write --set '/lights/-={"position": [1,2,3]}'"""),
    ("scene.json out.png 8 --only diffuse,,specular",
     'raytracer: --only: a comma too many in "diffuse,,specular"'),
    ("scene.json out.png 8 --only normals", 'raytracer: --only: no term "normals"; write --pass normals'),
    ("scene.json out.png 8 --only raycast", 'raytracer: --only: no term "raycast"; write --pass raycast'),
    ("scene.json out.png 8 --only raycasting",
     'raytracer: --only: no term "raycasting"; write --pass raycast'),
    ("scene.json out.png 8 --only normal", 'raytracer: --only: no term "normal"; write --pass normals'),
    ("scene.json f-%04d.png 8", "raytracer: the picture f-%04d.png needs --frames, for %04d"),
    ("scene.json out.png 8 --only ambient;diffuse",
     'raytracer: --only: expected commas between the terms, found "ambient;diffuse"'),
    ("scene.json out.png 8 --only ambient, diffuse, specular",
     "raytracer: --only has commas, no blanks: write --only ambient,diffuse,specular"),
    ("--only ambient diffuse scene.json out.png 8",
     "raytracer: --only has commas, no blanks: write --only ambient,diffuse"),
    ("my scene.json out.png 8", 'raytracer: there is a file "my scene.json": write its name in quotes'),
    ("./my scene.json out.png 8", 'raytracer: there is a file "./my scene.json": write its name in quotes'),
    ("--quiet compare a.png b.png", "raytracer: the command stands first: raytracer compare ..."),
    ("scene.json out.png 8 --set camera/eye=[0,1,5]",
     "scene.json: --set camera/eye: a pointer begins with /: write /camera/eye"),
    ("scene.json out.png 8 --set camera.eye=[0,0,4]",
     "scene.json: --set camera.eye: a pointer begins with /: write /camera/eye"),
    ("scene.json out.png 8 --set camera:eye=[0,0,4]",
     "scene.json: --set camera:eye: a pointer begins with /: write /camera/eye"),
    ("scene.json out.png 8 --set eye=[0,0,4]",
     "scene.json: --set eye: a pointer begins with /: write /camera/eye"),
    ("scene.json out.png 8 --set type=cube", "scene.json: --set type: a pointer begins with /"),
    ("scene.json out.png 8 --set $.camera.eye=[0,0,4]",
     "scene.json: --set $.camera.eye: a pointer begins with /: write /camera/eye"),
    ("scene.json out.png 8 --set -/camera/eye=[0,0,4]",
     "scene.json: --set -/camera/eye: a pointer begins with /: write /camera/eye"),
    ("scene.json out.png 8 --set camera/eye[0]=5",
     "scene.json: --set camera/eye[0]: a pointer begins with /: write /camera/eye/0"),
    ("scene.json out.png 8 --set /camera/eye/3=1",
     'scene.json: --set /camera/eye/3: /camera/eye has 3 elements, from 0: there is no "3"'),
    ("scene.json out.png 8 --set /materials/-/name=x",
     "scene.json: --set /materials/-/name: - adds an element, and ends its pointer: write /materials/-"),
    ("scene.json out.png 8 --set /materials/red/shininess=3",
     'scene.json: --set /materials/red/shininess: "red" is a name: '
     "write /materials/0/shininess"),
    ("scene.json out.png 8 --set /materials/red/color_diffuse=1,0,0",
     'scene.json: --set /materials/red/color_diffuse: "red" is a name: write /materials/0/color_diffuse'),
    ("scene.json out.png 8 --set /shapes/sphere/material=red",
     'scene.json: --set /shapes/sphere/material: /shapes has 2 elements, from 0: there is no "sphere"'),
    ("scene.json out.png 8 --set samples=4", "scene.json: --set samples: it is the option --samples"),
    (["scene.json", "out.png", "8", "--set", "/camera/eye = [0,0,4]"],
     "scene.json: --set /camera/eye : a blank stands before =: delete it"),
    ("scene.json out.png 8 --set /camera/eye:[0,0,4]",
     "raytracer: --set /camera/eye: write = for the : behind it"),
    ("scene.json out.png 8 --set /camera/eye=[0,0,4],/camera/look=[0,0,-1]",
     "raytracer: --set has one value: write another --set before /camera/look"),
    ("scene.json out.png 8 --set /lights/0.5=3",
     'scene.json: --set /lights/0.5: /lights has 1 element, from 0: there is no "0.5"; /lights/- adds one'),
    ("scene.json out.png 8 --set shapes[0].material=floor",
     "scene.json: --set shapes[0].material: a pointer begins with /: write /shapes/0/material"),
    ("scene.json out.png 8 --set /shapes/0.material=x",
     'scene.json: --set /shapes/0.material: steps are parted by /: write /shapes/0/material'),
    ("scene.json out.png 8 --set /camera.eye=x",
     'scene.json: --set /camera.eye: steps are parted by /: write /camera/eye'),
    ("scene.json out.png 8 --set /lights/={}",
     'scene.json: --set /lights/: /lights has 1 element, from 0: there is no ""; /lights/- adds one'),
    ("more out.png 8", "more: cannot read: Is a directory; name a file in it"),
    ("grade More", 'More: cannot read the folder: No such file or directory; there is "more"'),
    ("grade more", "more: no reference X.png or X-STAGE.png of a scene X.json; "
     "--references names their folder"),
    ("grade more --references textures",
     "textures: no reference X.png or X-STAGE.png of a scene X.json in more"),
    ("grade more/other.json",
     'more/other.json: cannot read the folder: Not a directory; name its folder "more"'),
    ("grade scene.json", 'scene.json: cannot read the folder: Not a directory; name its folder "."'),
    ("grade more --references more/other.json",
     'more/other.json: cannot read the folder: Not a directory; name its folder "more"'),
    ("tradeoff scene.json 60",
     'raytracer tradeoff: "60" is no scene: tradeoff takes scenes alone; write --size 60'),
    ("tradeoff scene.json new.png 60",
     'raytracer tradeoff: "new.png" is no scene: tradeoff takes scenes alone; --out names a folder'),
    ("grade graded --program ./nothere", "raytracer grade: --program: there is no file ./nothere"),
    ("grade graded --program ./programs/raytracr",
     'raytracer grade: --program: there is no file ./programs/raytracr; there is "./programs/raytracer"'),
    ("grade graded --program ./more", "raytracer grade: --program: ./more is a folder: name a program in it"),
    ("grade graded --program ./scene.json",
     "raytracer grade: --program: ./scene.json is not executable: chmod +x makes it so"),
    ("grade graded --program /usr/bin/nosuch",
     "raytracer grade: --program: there is no file /usr/bin/nosuch"),
    ("reference.json out.png 8", "reference.json: cannot read: No such file or directory; looked in HERE"),
    ("grade graded --program nosuchcmd", "raytracer grade: --program: there is no command nosuchcmd"),
    ("grade graded --program scene.json",
     "raytracer grade: --program: there is no command scene.json; write ./scene.json"),
    (["grade", "graded", "--program", "./nothere; true"],
     "raytracer grade: --program: there is no file ./nothere"),
    (["grade", "graded", "--program", "python3 progs/b.py"],
     "raytracer grade: --program: there is no file progs/b.py"),
    (["grade", "graded", "--program", "python3 -u programs/a.pyy.py x.py"],
     'raytracer grade: --program: there is no file programs/a.pyy.py; there is "programs/a.py"'),
    ("grade graded --submissions class --program nosuchcmd/{}",
     "raytracer grade: --program: no submission has a file nosuchcmd/{}"),
    ("grade graded --submissions class --program ./{}/raytracing",
     "raytracer grade: --program: write {}/raytracing: {} is the whole path of a submission"),
    ("grade graded --submissions class --program ./nothere",
     "raytracer grade: --program: expected {} for the submission's folder, found \"./nothere\""),
    ("grade graded --submissions class --program '{}/run'",
     "raytracer grade: --program: write {} without quotes: it is quoted already"),
    (["grade", "graded", "--submissions", "class", "--program", "sh -c 'cd {} && ./run'"],
     "raytracer grade: --program: write {} without quotes: it is quoted already"),
    (["grade", "graded", "--submissions", "class", "--program", "python3 {}/b.py"],
     "raytracer grade: --program: no submission has a file {}/b.py"),
    ("grade graded --report x.txt", "x.txt: expected a name that ends in .html or .htm"),
    ("grade graded --report x.pdf --program true", "x.pdf: expected a name that ends in .html or .htm"),
    ("scene.json out.jpg 8 --watch", "out.jpg: expected a name that ends in .png or .pfm"),
    ("scene.json out.png 8 --watch --crop 1,2",
     'raytracer: --crop: expected four whole numbers x0,y0,x1,y1, found "1,2"'),
    ("compare - out.png", "-: cannot read: No such file or directory; looked in HERE"),
    ("./u.txt out.png 8", "./u.txt: cannot read: No such file or directory; looked in HERE/"),
    ("more/unlike.txt out.png 8",
     "more/unlike.txt: cannot read: No such file or directory; looked in HERE/more"),
    ("nowhere/unlike.txt out.png 8",
     'nowhere/unlike.txt: cannot read: No such file or directory; there is no folder "nowhere"'),
    ("more/scene.json out.png 8",
     'more/scene.json: cannot read: No such file or directory; there is "scene.json"'),
    ("more\\scene.json out.png 8",
     'more\\scene.json: cannot read: No such file or directory; there is "scene.json"'),
    ("nowhere\\scene.json out.png 8",
     'nowhere\\scene.json: cannot read: No such file or directory; there is "scene.json"'),
    ("compare out.png scene.json", "scene.json: it is no PNG, JPEG or PFM picture: convert it to PNG"),
    ("compare out.png small.png", "small.png: expected 4 x 4 pixels, as in out.png, found 8 x 8"),
    ("sceen.json out.png 8", 'sceen.json: cannot read: No such file or directory; there is "scene.json"'),
    ("scene out.png 8", 'scene: cannot read: No such file or directory; there is "scene.json"'),
    ("other.json out.png 8",
     'other.json: cannot read: No such file or directory; there is "more/other.json"'),
    ("compare out.png refrence.png",
     'refrence.png: cannot read: No such file or directory; there is "reference.png"'),
    # Values that a shell has taken apart.
    ("scene.json out.png 8 --crop 0, 0 , 5, 5",
     "raytracer: --crop has commas, no blanks: write --crop 0,0,5,5"),
    ("scene.json out.png 8 --crop 0 ,0 ,5 ,5",
     "raytracer: --crop has commas, no blanks: write --crop 0,0,5,5"),
    ("scene.json out.png 8 --only ambient , diffuse",
     "raytracer: --only has commas, no blanks: write --only ambient,diffuse"),
    ("scene.json out.png 8 --set /camera/eye = 0, 1, 4",
     'raytracer: --set takes /pointer=value: write --set "/camera/eye=[0, 1, 4]"'),
    ("--set /camera/eye = 0, 1, 4 scene.json out.png 8",
     'raytracer: --set takes /pointer=value: write --set "/camera/eye=[0, 1, 4]"'),
    ("--set /camera/eye= scene.json out.pfm 8 9", f'raytracer: unexpected argument "9"; {ORDER}'),
    ("--set /camera/eye= - out.pfm 8 9", SCENE_ON_STDIN),
    ("scene.json out.png 8 --set /materials/0/name = $HOME",
     "raytracer: --set takes /pointer=value: write --set '/materials/0/name=$HOME'"),
    ("scene.json f-%04d.png 8 --frames 1..3 --set /camera/eye/0=0 /camera/eye/0=1",
     "raytracer: --set needs quotes around braces: write --set '/camera/eye/0={0..1}'"),
    (["scene.json", "out.png", "8", "--set", "/shapes/-=name:a b", "/shapes/-=on:true"],
     "raytracer: --set needs quotes around braces: "
     """write --set '/shapes/-={"name":"a b","on":true}'"""),
    ("scene.json out.png 8 --set /lights/-=position:[3 /lights/-=5 /lights/-=4e1] /lights/-=on:true",
     "raytracer: --set needs quotes around braces: "
     """write --set '/lights/-={...}'"""),
    ("scene.json out.png 8 --part 1 2", "raytracer: --part is K/N, no blanks: write --part 1/2"),
    ("scene.json out.png 8 --part 1 / 2", "raytracer: --part is K/N, no blanks: write --part 1/2"),
    ("--part 1 of 2 scene.json out.png 8", "raytracer: --part is K/N, no blanks: write --part 1/2"),
    ("--frames 1 8 scene.json f-%04d.png 8", "raytracer: --frames is A..B, no blanks: write --frames 1..8"),
    ("--frames 1 .. 8 scene.json f-%04d.png 8",
     "raytracer: --frames is A..B, no blanks: write --frames 1..8"),
    ("--frames 1 to 8 scene.json f-%04d.png 8",
     "raytracer: --frames is A..B, no blanks: write --frames 1..8"),
    ("scene.json f-%04d.png 8 --frames 1..3 --set /camera/eye/0=1 /camera/eye/0=0 /camera/eye/0=-1",
     "raytracer: --set needs quotes around braces: write --set '/camera/eye/0={1..-1}'"),
    ("scene.json out.png 8 --set /camera/eye=0 /camera/eye=1 /camera/eye=5",
     "raytracer: --set needs quotes around braces: write --set '/camera/eye=[0,1,5]'"),
    ("scene.json f-%04d.png 8 --frames 1..3 --set /camera/eye=[{0-1},0,4]",
     "raytracer: --set /camera/eye=[{0-1},0,4]: a range is {0..1}"),
    ("scene.json f-%04d.png 8 --frames 1..3 --set /camera/eye/0={0..}",
     "raytracer: --set /camera/eye/0={0..}: a range is {0..1}"),
    ("scene.json f-%04d.png 8 --frames 1..3 --set /camera/eye/0=0..1",
     "raytracer: --set /camera/eye/0=0..1: a range is {0..1}"),
    ("scene.json f-%04d.png 8 --frames 1..3 --set /camera/eye/0={0..1",
     "raytracer: --set /camera/eye/0={0..1: a range is {0..1}"),
    ("scene.json out.png 8 --set /camera/eye/0={0:1}",
     "raytracer: --set /camera/eye/0={0:1}: a range is {0..1}"),
    ("scene.json f-%04d.png 8 --frames 1..3 --set /camera/eye/0={0,1}",
     "raytracer: --set /camera/eye/0={0,1}: a range is {0..1}"),
    # Options written in another way.
    ("scene.json out.png 8 --max-recursion = 3", 'raytracer: unexpected "="; write --max-recursion 3'),
    ("scene.json out.png 8 --max-recursion =3", 'raytracer: unexpected "="; write --max-recursion 3'),
    ("scene.json out.png 8 --max-recursion =x",
     'raytracer: --max-recursion: expected a whole number from 0 to 1000, found "x"'),
    ("scene.json out.png 8 --report =", "raytracer: unknown option --report (see --help)"),
    ("scene.json out.png 8 --only = diffuse", 'raytracer: unexpected "="; write --only diffuse'),
    ("scene.json out.png 8 /max-recursion 3",
     'raytracer: unexpected argument "/max-recursion"; write --max-recursion 3'),
    ("scene.json out.png 8 max-recursion=3",
     'raytracer: unexpected argument "max-recursion=3"; write --max-recursion 3'),
    ("max-recursion=3 scene.json out.png 8",
     'raytracer: unexpected argument "max-recursion=3"; write --max-recursion 3'),
    ("scene.json out.png 8 quiet", 'raytracer: unexpected argument "quiet"; write --quiet'),
    ("scene.json out.png 8 /max-recursion=3",
     'raytracer: unexpected argument "/max-recursion=3"; write --max-recursion 3'),
    ("scene.json out.png 8 --max-recursion",
     "raytracer: --max-recursion: expected a whole number from 0 to 1000, found nothing"),
    ("scene.json out.png 8 --pass compare",
     'raytracer: --pass: expected color, raycast or normals, found "compare"'),
    ("--quiet -- compare o.png 100", "compare: cannot read: No such file or directory; looked in HERE"),
    ("--json compare a.png b.png", "raytracer: the command stands first: raytracer compare ..."),
    ("--threads 2 grade graded", "raytracer: the command stands first: raytracer grade ..."),
    ("scene.json out.png 8 --only", "raytracer: --only: expected terms, as ambient,diffuse, found nothing"),
    ("scene.json out.png 8 --crop", "raytracer: --crop: expected x0,y0,x1,y1, found nothing"),
    ("scene.json out.png 8 --part", "raytracer: --part: expected K/N, found nothing"),
    ("scene.json out.png 8 --frames", "raytracer: --frames: expected A..B, found nothing"),
    ("scene.json out.png 8 --set", "raytracer: --set: expected /pointer=value, found nothing"),
    (["scene.json", "out.png", "8", "--only", ""],
     'raytracer: --only: expected terms, as ambient,diffuse, found ""'),
    (["scene.json", "out.png", "8", "--set", ""], 'raytracer: --set: expected /pointer=value, found ""'),
    (["explain", "scene.json", "", "5"], 'raytracer explain: X: expected a whole number, found ""'),
    (["explain", "scene.json", "5,", "5"], 'raytracer explain: X: expected a whole number, found "5,"'),
    ("explain scene.json 5,5,5 5",
     'raytracer explain: X: expected a whole number, found "5,5,5"; write 5 5 5'),
    ("compare --print-completion xyz",
     'raytracer compare: --print-completion: expected bash, zsh or fish, found "xyz"'),
    ("-i scene.json -o out.png -w 8 -h 8", f"raytracer: unknown option -i; {ORDER}"),
    ("--unknown --help", "raytracer: unknown option --unknown (see --help)"),
    # Commands and arguments.
    ("assemble no.part out.png", "no.part: cannot read: No such file or directory; looked in HERE"),
    ("assemble p.png", "raytracer assemble: PART is missing; the order is PART... IMAGE_OUT (see --help)"),
    ("reference.png out.png", "raytracer: reference.png is a picture; "
     "write raytracer compare reference.png out.png"),
    ("scene.json 600 600", f"raytracer: IMAGE_OUT is missing; {ORDER} (see --help)"),
    ("- out.png 8", SCENE_ON_STDIN),
    ("- - 8", SCENE_ON_STDIN),
    ("explain - 3 3 8", SCENE_ON_STDIN.replace("raytracer:", "raytracer explain:")),
    ("grade graded refs", "raytracer grade: one folder is graded; write --references refs"),
    ("grade a.json b.png",
     "raytracer grade: it takes a folder; write raytracer explain a.json --picture b.png"),
    ("grade b.png a.json",
     "raytracer grade: it takes a folder; write raytracer explain a.json --picture b.png"),
    ("grade a.png b.png", "raytracer grade: it takes a folder; write raytracer compare a.png b.png"),
    ("grade", "raytracer grade: DIR is missing; the order is DIR (see --help)"),
    ("explain scene.json mine.png 3 3",
     "raytracer explain: is mine.png the picture? Give it with --picture; "
     "the order is SCENE X Y LONG_EDGE_PIXELS"),
    ("scene.json out.png 8 --diffuse", "raytracer: unknown option --diffuse; did you mean --only diffuse?"),
    ("scene.json out.png 8 --raycast", "raytracer: unknown option --raycast; did you mean --pass raycast?"),
    ("scene.json out.png 8 --normals", "raytracer: unknown option --normals; did you mean --pass normals?"),
    ("scene.json out.png 8 --no-shadows",
     "raytracer: unknown option --no-shadows: --only names the terms that are left (see --help)"),
    ("scene.json out.png 8 --no-strict", "raytracer: unknown option --no-strict (see --help)"),
    ("scene.json out.png 8 --float", "raytracer: unknown option --float; did you mean --precision float?"),
    ("scene.json out.png 8 --bilinear",
     "raytracer: unknown option --bilinear; did you mean --texture-filter bilinear?"),
    ("scene.json out.png 8 --region 1,1,2,2", "raytracer: unknown option --region; did you mean --crop?"),
    ("scene.json out.png 8 --cores 2", "raytracer: unknown option --cores; did you mean --threads?"),
    ("scene.json out.png 8 --gamma 2.2",
     "raytracer: there is no --gamma: a byte is 255 times the linear colour; a .pfm has that itself"),
    ("compare a.png b.png --out d.png", "raytracer compare: unknown option --out; did you mean --diff?"),
    ("compare a.png b.png -o d.png", "raytracer compare: unknown option -o; did you mean --diff?"),
    ("compare a.png b.png --threshold 1",
     "raytracer compare: unknown option --threshold; did you mean --tolerance?"),
    ("scene.json out.png 8 --pass diffuse",
     'raytracer: --pass: expected color, raycast or normals, found "diffuse"; write --only diffuse'),
    ("scene.json out.png 8 --pass shadows",
     'raytracer: --pass: expected color, raycast or normals, found "shadows"; write --only diffuse,shadows'),
    ("scene.json out.png 8 --only ambient_diffuse_specular",
     "raytracer: --only has commas, no underscores: write --only ambient,diffuse,specular"),
    ("scene.json out.png 8 --only all", 'raytracer: --only: no term "all"; without --only there are all'),
    ("scene.json - 8 --stats",
     "raytracer: the picture - and --stats both go to standard output: name a file for the picture"),
    ("schema", 'raytracer: unknown command "schema"; write raytracer --print-schema'),
    ("man", 'raytracer: unknown command "man"; write raytracer --print-manual'),
    ("watch scene.json",
     'raytracer: unknown command "watch"; write raytracer SCENE IMAGE_OUT LONG_EDGE_PIXELS --watch'),
    ("scene.json out.png 8 --texture-filter Bilinear",
     'raytracer: --texture-filter: expected bilinear, found "Bilinear"'),
    ("scene.json out.png 8 --target-time 10s",
     'raytracer: --target-time: expected a number above 0, found "10s"; write 10'),
    ("scene.json out.png 8 --adaptive 2%",
     'raytracer: --adaptive: expected a number from 0 to 1, found "2%"; write 0.02'),
    ("scene.json out.png 8 --adaptive 0,02",
     'raytracer: --adaptive: expected a number from 0 to 1, found "0,02"; write 0.02'),
    ("scene.json out.png 600px",
     'raytracer: LONG_EDGE_PIXELS: expected a whole number from 1 to 65536, found "600px"; write 600'),
    ("grade graded --max-pixels 100%",
     'raytracer grade: --max-pixels: expected a whole number not below 0, found "100%"'),
    ("scene.json out.png 8 --samples 300%",
     'raytracer: --samples: expected a whole number from 1 to 65536, found "300%"'),
    ("grade graded --csv x.xlsx", "x.xlsx: what is written is CSV, not a workbook: name it x.csv"),
    ("tradeoff scene.json --out x.html", "x.html: --out names a folder, for three files"),
    ("grade graded --program true --user nobodyhere", "raytracer grade: --user: " + NO_USER),
    ("grade graded --stage diffuse", "graded: no reference X-diffuse.png of a scene X.json; "
     "--references names their folder"),
    ("grade graded --stage normals --submissions class",
     "graded: no reference X-normals.png of a scene X.json; --references names their folder"),
    ("grade graded --references refs --stage normals",
     "refs: no reference X-normals.png of a scene X.json in graded"),
    ("grade stages --program true",
     "stages: no reference X.png of a scene X.json; --references names their folder"),
]

# What is changed in the scene, the place, what is answered, and for a mistake of syntax the column of the
# mark.
SCENES = [
    ('"floor" }\n    ]', '"floor" },\n    ]', "15:70", 'a comma too many before "]"'),
    ('"focal_length": 1,', '"focal_length": 1', "3:49", "a comma is missing here"),
    ("-0.5, \"film_r", "-0,5, \"film_r", "4:24", "a number has a decimal point: write -0.5"),
    ('"lights": [', '"lights": [ // the sun\n', "11:17", "a comment, which JSON does not have: delete it"),
    ('"red"', "'red'", "8:19", "text stands in double quotes, not in single ones"),
    ("true", "True", "9:51", 'expected true, found "True": small letters'),
    ("40", "+40", "8:73", "a number has no plus in front: write 40"),
    ("40", "360/4", "8:73", 'JSON does not calculate: write the result of "360/4"'),
    ("40", "NaN", "8:73", 'expected a finite number, found "NaN"'),
    ('"sphere"', "sphere", "14:19", 'expected a value, found "sphere": write "sphere" if it is a text'),
    ('"shininess"', "shininess", "8:60", 'a key stands in double quotes: write "shininess"'),
    ("textures/wood.png", "C:\\wood.png", "6:30",
     "a backslash in a text is written twice; in a path, write /"),
    ("[3, 5, 4]", "[3, 5, 4", "11:39", '"]" is missing at the end of the list of line 11'),
    ('"red"', '"red', "8:19", 'a text has no end: " is missing'),
    ('"ball"', '"ball', "12:31", 'a text has no end: " is missing'),
    ('"name": "red"', '"name: "red"', "8:11", 'a text has no end: " is missing'),
    ('"wood" }\n', '"wood }\n', "9:76", 'a text has no end: " is missing in this line'),
    ('"camera": {', '"camera": [', "2:15", "keys stand in { and }, not in [ and ]"),
    ("[3, 5, 4]", "{3, 5, 4}", "11:31", "a list stands in [ and ], not in { and }"),
    ('"lights": [', '"lights": {', "11:15", "a list stands in [ and ], not in { and }"),
    ("[1, 1, 1] } ]", "[1, 1, 1] } ]]", "11:64", "a bracket too many"),
    ("[1, 1, 1] } ]", "[1, 1, 1] } ]}", "11:64", "a bracket too many"),
    ("[3, 5, 4]", "[3, 5, 4]]", "11:40", "a bracket too many"),
    ("[3, 5, 4]", "[3, 5, 4]}", "11:40", "a bracket too many"),
    ("[1, 1, 1] } ]", "[1, 1, 1] ]", "11:61", '"}" is missing at the end of the object of line 11'),
    ("40", "--40", "8:73", 'expected a number, found "--40"'),
    ("40", "\u221240", "8:73", "a minus is the sign -: write -40"),
    ("40", "sqrt(2)", "8:73", 'JSON does not calculate: write the result of "sqrt(2)"'),
    ("40", "pi/2", "8:73", 'JSON does not calculate: write the result of "pi/2"'),
    ("40", "1,000", "8:74", "a number has no comma: write 1000, or 1.000"),
    ("40", "None", "8:73", 'expected a value, found "None": leave out a key that has none'),
    ("true", "undefined", "9:51", 'expected a value, found "undefined": leave out a key that has none'),
    ("true", "yes", "9:51", 'expected a value, found "yes": write true, or a text in double quotes'),
    ("true", "tru", "9:51", 'expected a value, found "tru": write true, or a text in double quotes'),
    ("true", "truee", "9:51", 'expected a value, found "truee": write true, or a text in double quotes'),
    ('"lights"', '-- sun\n"lights"', "11:5", "a comment, which JSON does not have: delete it"),
    ('"lights"', '<!-- sun -->\n"lights"', "11:5", "a comment, which JSON does not have: delete it"),
    ('"lights"', '\u00a0"lights"', "11:5", "an invisible character (U+00A0): delete it"),
    ("[0, 0, 4]", "{0, 0, 4]", "3:58", "a list stands in [ and ], not in { and }"),
    ("[0.8, 0.1, 0.1]", "[.8, .1, .1]", "8:43", "a point stands between digits: write [0.8, 0.1, 0.1]"),
    ("[0, 0, 4]", "[+1, 0, 4]", "3:58", "a number has no plus in front: write [1, 0, 4]"),
    ("[0, 0, 4]", "[1., 0, 4]", "3:58", "a point stands between digits: write [1.0, 0, 4]"),
    ("[0.8, 0.1, 0.1]", "rgb(255, 0, 0)", "8:43", "a list stands in [ and ]: write [255, 0, 0]"),
    ("[0, 0, 4]", "<0, 0, 4>", "3:58", "a list stands in [ and ]: write [0, 0, 4]"),
    ("[0, 0, 4]", "0 0 4", "3:58", "a list stands in [ and ]: write [0, 0, 4]"),
    ('"eye": [', '"eye" = [', "3:57", 'expected ":" behind a key, found "="'),
    ("[0, 0, 4]", "[0, 0, 4}", "3:66", 'expected "]", found "}"'),
    ('"red" },\n        {', '"red" },\n        ', "15:10", '"{" is missing before this key'),
    ('"ball" }, {', '"ball" },', "12:41", '"{" is missing before this key'),
    ("[0.8, 0.1, 0.1]", "[0.8, 0.1, 0.1", "8:57",
     '"]" is missing at the end of the list of line 8'),
    ('"lights"', '\u200b"lights"', "11:5", "an invisible character (U+200B): delete it"),
    ("40", "<40>", "8:73", 'expected a number, found "<40>"'),
    ('"red" }', '"red" )', "14:68", 'expected "}", found ")"'),
    ("40 }", "40)", "8:75", 'expected "}", found ")"'),
    ("[3, 5, 4]", "[3, 5, 4)", "11:39", 'expected "]", found ")"'),
    ("[3, 5, 4]", "[3, 5, 4])", "11:40", "a bracket too many"),
    ('"red" }', '"red" } )', "14:70", "a bracket too many"),
    ("40", "2 units", "8:73", "a number has no unit: write 2"),
    ("[3, 5, 4]", "[3, 5, )", "11:38", 'expected "]", found ")"'),
    ('"lights"', '% the sun\n"lights"', "11:5", "a comment, which JSON does not have: delete it"),
    ('40 }', '40 % shiny\n}', "8:76", "a comment, which JSON does not have: delete it"),
    ('"lights": [', '"lights": [ ; sun\n', "11:17", "a comment, which JSON does not have: delete it"),
    ('"red" }', '"red" } ; red', "14:70", "a comment, which JSON does not have: delete it"),
    ('"red",', '"red";', "8:24", 'expected a comma, found ";"'),
    ("[3, 5, 4]", "[3; 5; 4]", "11:33", 'expected a comma, found ";"'),
    ("40", "40 % 3", "8:73", 'JSON does not calculate: write the result of "40 % 3"'),
    ("[3, 5, 4]", "[3, 5, 4]/2", "11:31", 'JSON does not calculate: write the result of "[3, 5, 4]/2"'),
    ("[3, 5, 4]", "2 * [3, 5, 4]", "11:31",
     'JSON does not calculate: write the result of "2 * [3, 5, 4]"'),
    ("40", "1 m", "8:73", "a number has no unit: write 1"),
    ("40", "45 deg", "8:73", "a number has no unit: write 45"),
    ("40", "45deg", "8:73", "a number has no unit: write 45"),
    ("40", "45\u00b0", "8:73", "a number has no unit: write 45"),
    ("40", "40 true", "8:75", "a comma is missing here"),
    ("[3, 5, 4]", "3, 5, 4", "11:31", "a list stands in [ and ]: write [3, 5, 4]"),
    ("[3, 5, 4]", "-3,5,4", "11:31", "a list stands in [ and ]: write [-3, 5, 4]"),
    ('"camera": {', '"camera": {{', "2:16", "a bracket too many"),
    ("[1, 1, 1]", "#fff", "11:51", "a color is 3 numbers: write [1, 1, 1]"),
    ("[1, 1, 1]", "#fff more", "11:51", "a comment, which JSON does not have: delete it"),
    ('"shapes": [', '"shapes": [ #add more', "13:17", "a comment, which JSON does not have: delete it"),
    ("[0, 0, 4]", "0,\n 1,\n 4", "3:58", "a list stands in [ and ]: write [0, 1, 4]"),
    ("[0, 0, 4]", "0, 1, eye: 3", "3:58", "a list stands in [ and ]"),
    ("[0, 0, 4]", "0,1, 4", "3:58", "a list stands in [ and ]: write [0, 1, 4]"),
    ("[0, 0, 4]", "x: 3, y: 5, z: 4", "3:58", "a list stands in [ and ]: write [3, 5, 4]"),
    ("[0, 0, 4]", "[x=3, y=5]", "3:58", "the numbers of a list have no names: write [3, 5]"),
    ("[0, 0, 4]", "new Vector3(3,5,4)", "3:58", "a list stands in [ and ]: write [3, 5, 4]"),
    ("[0, 0, 4]", "vec3(3, 5, 4)", "3:58", "a list stands in [ and ]: write [3, 5, 4]"),
    ("[0, 0, 4]", "np.array([3, 5, 4])", "3:58", "a list stands in [ and ]: write [3, 5, 4]"),
    ("[0, 0, 4]", "(3, +5, .4)", "3:58",
     "a list stands in [ and ]: write [3, 5, 0.4]"),
    ("[0, 0, 4]", "pow(2, 3)", "3:58", 'JSON does not calculate: write the result of "pow(2, 3)"'),
    ("[0, 0, 4]", "[3, 5, ...]", "3:65", 'expected a value, found "..."'),
    ("[0, 0, 4]", "[3: 5: 4]", "3:60", 'expected a comma, found ":"'),
    ("[0, 0, 4]", "[0 100 200]", "3:60", "a comma is missing here"),
    ("[0, 0, 4]", '["]", 1] * 2', "3:58",
     'JSON does not calculate: write the result of "[\\"]\\", 1] * 2"'),
    ("[0, 0, 4]", '"x,y" + "b"', "3:58",
     'JSON does not calculate: write the result of "\\"x,y\\" + \\"b\\""'),
    ("40", "\u03c0", "8:73", 'JSON has no constants: write the number for "\u03c0"'),
    ("40", "\u00bd", "8:73", 'expected a value, found "\u00bd"'),
    ("40", "M_PI", "8:73", 'JSON has no constants: write the number for "M_PI"'),
    ("40", "1,000,000", "8:73", "a number has no separator of thousands: write 1000000"),
    ("40", "1 000", "8:73", "a number has no separator of thousands: write 1000"),
    ("40", "1, 000", "8:73", "a number has no separator of thousands: write 1000"),
    ("40", "1.000,5", "8:73", "a number has no separator of thousands: write 1000.5"),
    ("40", "1,000.5", "8:73", "a number has no separator of thousands: write 1000.5"),
    ("40", "1_000", "8:73", "a number has no separator of thousands: write 1000"),
    ("40", "1'000", "8:73", "a number has no separator of thousands: write 1000"),
    ("40", "100,200,300", "8:73", "a list stands in [ and ]: write [100, 200, 300]"),
    ("40", "+.5", "8:73", "a number has no plus in front: write 0.5"),
    ("40", "+40 m", "8:73", "a number has no plus in front"),
    ("40", "-05.", "8:73", "a number has no zero in front: write -5.0"),
    ("40", "(40)", "8:73", "JSON has no ( and ): write 40"),
    ("40", "(40", "8:73", "JSON has no ( and )"),
    ('"red"', '("red")', "8:19", 'JSON has no ( and ): write "red"'),
    ('"camera": {', '"camera": (', "2:15", "JSON has no ( and )"),
    ("{\n", "({\n", "1:1", "JSON has no ( and )"),
    ('"red"', 'r"red"', "8:19", 'a text begins with its quote: write "red"'),
    ('"red"', "red ball", "8:19", 'expected a value, found "red"'),
    ('"name": "red"', '"name": "the "red" one"', "8:24", 'a quote in a text is written \\"'),
    ('"name": "red"', '"name": ""red""', "8:20", 'a quote in a text is written \\"'),
    ('"name": "red"', '"na"me": "red"', "8:14", 'a quote in a text is written \\"'),
    ('{ "name": "red"', '{ 1: "red"', "8:11", 'a key stands in double quotes: write "1"'),
    ('"shininess":', "shininess =", "8:60", 'a key stands in double quotes: write "shininess"'),
    ('{ "name": "red", "color_diffuse": [0.8, 0.1, 0.1], "shininess": 40 }',
     '{ { "name": "red", "color_diffuse": [0.8, 0.1, 0.1], "shininess": 40 } }', "8:11",
     "a bracket too many"),
    ('"name": "red",', '"name": "red"; name: 1,', "8:24", 'expected a comma, found ";"'),
    ('0.5\n    },', '0.5\n    ,', "6:5", '"}" is missing at the end of the object of line 2'),
    ('0.5\n    },', '0.5,', "5:5", '"}" is missing at the end of the object of line 2'),
    ('textures/wood.png" },', 'textures/wood.png" ,', "7:5",
     '"}" is missing at the end of the object of line 6'),
    ('"camera": {', '"camera":', "3:9", '"{" is missing before this key'),
    ('"textures": {', '"textures":', "6:17", '"{" is missing before this key'),
    ('"name": "red",', '"name": "red":', "8:24", 'expected a comma, found ":"'),
    ('"lights": [', '<<<<<<< HEAD\n    "lights": [', "11:5",
     "a merge conflict: keep one of the versions"),
    ("{\n", "# Blender\nv 1 -.5 2\n", "1:1", "expected a scene, found an OBJ mesh"),
    ("{\n", "<!DOCTYPE html>\n", "1:1", "expected a scene, found a web page"),
    ("{\n", '<?xml version="1.0"?>\n', "1:1", "expected a scene, found XML"),
    ("{\n", "version https://git-lfs.github.com/spec/v1\n", "1:1",
     "expected a scene, found a pointer of Git LFS: git lfs pull gets the file"),
    ("{\n", "%PDF-1.4\n", "1:1", "expected a scene, found a PDF"),
    ("{\n", "---\n", "1:1", 'expected "{", found "---"'),
    ("{\n", "```json\n{\n", "1:1", 'expected "{", found "```json"'),
    ("{\n", "var scene = {\n", "1:1", 'expected "{", found "var"'),
]
MEANINGS = [
    ('"material": "red"', '"material": "rde"', "14:62",
     '/shapes/0/material: no material named "rde"; did you mean "red"?'),
    ('"sphere"', '"ball"', "14:19",
     '/shapes/0/type: expected sphere, plane, cylinder, cone, cube or mesh, found "ball"'),
    ("focal_length", "focal_lenght", "3:32",
     '/camera: expected the key "focal_length", found "focal_lenght"'),
    ('"sphere"', '"shpere"', "14:19", '/shapes/0/type: expected "sphere", found "shpere"'),
    ('"look"', '"lookat"', "3:69",
     '/camera: unknown key "lookat": look is the direction, the target minus the eye'),
    ('"shapes"', '"objects"', "13:5", 'expected the key "shapes", found "objects"'),
    ('"type": "cube"', '"type": "mesh", "file": "a.obj"', "15:27",
     '/shapes/1: expected the key "path", found "file"'),
    ('"type": "perspective", "focal_length": 1', '"a": 1, "b": 2, "c": 3, "d": 4', "3:9",
     '/camera: expected the key "type", found "a", "b", "c" and others'),
    ('"wood" }\n', '"textures/wood.png" }\n', "9:76",
     '/materials/1/diffuse_texture: no texture named "textures/wood.png"; it is the path of "wood"'),
    ('"textures": { "wood": "textures/wood.png" },', "", "9:76",
     '/materials/1/diffuse_texture: no texture named "wood": the scene has no textures'),
    ('"name": "ball"', '"name": "floor"', "12:52",
     '/transforms/1/name: the name "floor" is taken by /transforms/0/name: choose another'),
    ('"shininess"', '"color_diffuse"', "8:60",
     '/materials/0: expected each key once, found "color_diffuse" twice'),
    ('"translate": [0, -1, 0]', '"matrix": [[1,0,0,5],[0,1,0,0],[0,0,1,0],[0,0,0,1]]', "12:78",
     "/transforms/1/matrix/0/3: expected 0 in the bottom row (the lists are columns), found 5"),
    ("[0, 0, 4]", "[0, 0]", "3:58", "/camera/eye: expected 3 numbers, found a list of 2"),
    ("[0.8, 0.1, 0.1]", '"red"', "8:43",
     '/materials/0/color_diffuse: expected 3 numbers, red, green and blue, found "red"'),
    ("[0.8, 0.1, 0.1]", '"#f00"', "8:43",
     '/materials/0/color_diffuse: expected 3 numbers, found "#f00": write [1, 0, 0]'),
    ('"focal_length": 1', '"focal_length": "1"', "3:48",
     '/camera/focal_length: expected a number without quotes, found "1"'),
    ("true", '"true"', "9:51",
     '/materials/1/use_diffuse_texture: expected true or false without quotes, found "true"'),
    ("true", '"False"', "9:51",
     '/materials/1/use_diffuse_texture: expected true or false as false, without quotes, found "False"'),
    ("[3, 5, 4]", '"[3, 5, 4]"', "11:31",
     '/lights/0/position: expected 3 numbers or 4 without quotes, found "[3, 5, 4]"'),
    ("[0, 0, 4]", '"[0, 0, 4]"', "3:58",
     '/camera/eye: expected 3 numbers without quotes, found "[0, 0, 4]"'),
    ("textures/wood.png", "wood.png", "6:27",
     '/textures/wood: no file "wood.png" (relative to the scene file); write "textures/wood.png"'),
    ("textures/wood.png", "Textures\\\\wood.png", "6:27",
     '/textures/wood: no file "Textures\\\\wood.png" (relative to the scene file); write '
     '"textures/wood.png"'),
    ("textures/wood.png", "..\\\\textures\\\\wood.png", "6:27",
     '/textures/wood: no file "..\\\\textures\\\\wood.png" (relative to the scene file); write '
     '"textures/wood.png"'),
    ("textures/wood.png", "C:\\\\Users\\\\ada\\\\textures\\\\wood.png", "6:27",
     '/textures/wood: no file "C:\\\\Users\\\\ada\\\\textures\\\\wood.png" '
     '(relative to the scene file); write "textures/wood.png"'),
    ("textures/wood.png", "/home/ada/textures/wood.png", "6:27",
     '/textures/wood: no file "/home/ada/textures/wood.png"; write "textures/wood.png"'),
    ("[0, 0, 4]", '"#123"', "3:58", '/camera/eye: expected 3 numbers, found "#123"'),
    ("[0, 0, 4]", '"0 0 4"', "3:58", '/camera/eye: expected 3 numbers, found "0 0 4": write [0, 0, 4]'),
    ("[0, 0, 4]", '{"z": 4, "y": 0.5, "x": 0}', "3:58",
     "/camera/eye: expected 3 numbers, found an object: write [0, 0.5, 4]"),
    ("[0, 0, 4]", '{"z": 4, "y": 0.5, "a": 0}', "3:58", "/camera/eye: expected 3 numbers, found an object"),
    ("[3, 5, 4]", '"3 5 4"', "11:31",
     '/lights/0/position: expected 3 numbers or 4, found "3 5 4": write [3, 5, 4]'),
    ("[0.8, 0.1, 0.1]", "0.5", "8:43",
     "/materials/0/color_diffuse: expected 3 numbers, found 0.5: write [0.5, 0.5, 0.5]"),
    ('"translate": [0, -1, 0]', '"scale": 2', "12:69",
     "/transforms/1/scale: expected 3 numbers, found 2: write [2, 2, 2]"),
    ('"translate": [0, -1, 0]', '"rotate": {"degrees": 90, "axis": "-Y"}', "12:94",
     '/transforms/1/rotate/axis: expected 3 numbers, found "-Y": write [0, -1, 0]'),
    ('"translate": [0, -1, 0]', '"rotate": [90, 0, 0]', "12:70",
     '/transforms/1/rotate: expected {"degrees": 90, "axis": [0, 1, 0]}, found a list of 3'),
    ('"translate": [0, -1, 0]', '"rotate": [{"degrees": 90, "axis": [0, 1, 0]}]', "12:70",
     "/transforms/1/rotate: expected one rotation (a matrix takes more), found a list of 1"),
    ('"translate": [0, -1, 0]', '"rotate": {"radians": 1, "axis": [0, 1, 0]}', "12:71",
     '/transforms/1/rotate: unknown key "radians": degrees are radians times 180 / pi'),
    ('"focal_length": 1', '"focal_length": "1,5"', "3:48",
     "/camera/focal_length: expected a number: a number has a decimal point: write 1.5"),
    ('"focal_length"', '"fov"', "3:32",
     '/camera: unknown key "fov": focal_length and film_left to film_top give the angle'),
    ('"look"', '"target"', "3:69",
     '/camera: unknown key "target": look is the direction, the target minus the eye'),
    ("[0, 1, 0]", "[0, 0, 2]", "3:95",
     "/camera/up: expected another direction than look's, found its opposite"),
    ("[0, 1, 0]", "[0, 0, -2]", "3:95",
     "/camera/up: expected another direction than look's, found the same"),
    ('"textures": {', '"texture": {', "6:5", 'unknown key "texture"; did you mean "textures"?'),
    ('"name": "red"', '"id": "red"', "8:11", '/materials/0: unknown key "id"; did you mean "name"?'),
    ('"name": "red"', '"Name": "red"', "8:11", '/materials/0: unknown key "Name"; did you mean "name"?'),
    ('"name": "red",', "", "14:62",
     '/shapes/0/material: no material named "red"; /materials/0 has no name'),
    ('"transform": "ball"', '"transform": "identity"', "14:42",
     '/shapes/0/transform: no transform named "identity"; there are "ball" and "floor"'),
    ('"transform": "ball"', '"transform": {"scale": [1, 1, 1]}', "14:42",
     "/shapes/0/transform: expected the name of a transform, found an object"),
    ('"material": "red"', '"material": 1', "14:62",
     "/shapes/0/material: expected the name of a material, found 1"),
]
# What is set, and what is answered.
SETS = [
    ("/camera/eye=[0,1,5", 'expected 3 numbers: "]" is missing at the end of the list'),
    ("/lights/0/position=1,2,3", 'expected 3 numbers or 4, found "1,2,3": write [1, 2, 3]'),
    ("/lights/0={position:[0,1,2]}",
     'expected an object: a key stands in double quotes: write "position"'),
    ("/materials/0/shininess=+40", "expected a number: a number has no plus in front: write 40"),
    ("/materials/0/shininess=forty", 'expected a number, found "forty"'),
    ("/materials/0/reflective=True", 'expected true or false in small letters, found "True"'),
    ("/lights/0/color=#fff",
     'expected 3 numbers, found "#fff": write [1, 1, 1]'),
    ("/lights/0/color=#FF8000",
     'expected 3 numbers, found "#FF8000": write [1, 0.502, 0]'),
    ("/camera/focal_length=1,5", "expected a number: a number has a decimal point: write 1.5"),
    ("/camera/focal_length=1,2,3", 'expected a number, found "1,2,3"'),
    ("/camera/focal_length=1e999", "expected a finite number, found 1e999"),
    ("/camera/eye='[0,0,4]'", """expected 3 numbers without quotes, found "'[0,0,4]'\""""),
    ("/camera/eye=1 2 3", 'expected 3 numbers, found "1 2 3": write [1, 2, 3]'),
    ("/camera/eye={0,0,4}", "expected 3 numbers: a list stands in [ and ], not in { and }"),
    ("/transforms/0/scale=0", "expected 3 numbers, found 0"),
    ("/lights/0/color=rgb(255, 0, 0)",
     "expected 3 numbers: a list stands in [ and ]: write [255, 0, 0]"),
    ("/materials/0/color_diffuse=(0.8, 0.1, 0.1)", "expected 3 numbers: write [0.8, 0.1, 0.1]"),
    ("/materials/0/color_diffuse=(1,0,0)", "expected 3 numbers: write [1, 0, 0]"),
    ("/camera/eye=(0,0,4)",
     "expected 3 numbers: a list stands in [ and ]: write [0, 0, 4]"),
]
# What is changed in the scene, and rendered with a warning; with --strict it is an error.
WARNINGS = [
    ('"shininess"', '"shinyness"', "8:60",
     '/materials/0: unknown key "shinyness"; did you mean "shininess"?'),
    ('"color_diffuse"', '"diffuse"', "8:26",
     '/materials/0: unknown key "diffuse"; did you mean "color_diffuse"?'),
    ('"shininess"', '"<b>"', "8:60", '/materials/0: unknown key "<b>": delete it'),
    ('"lights": [ {', '"lights": [ { "position": [0, 0, 0] }, {', "11:17",
     "/lights/0: hidden inside of /shapes/0, an opaque sphere: move the light out"),
    ('"name": "ball"', '"name": "ball", "translate": [9, 0, 0]', "14:9",
     "/shapes/0: the sphere is to the right of the view, so unseen but for its shadow: move it"),
    ("[0.8, 0.1, 0.1]", "[200, 20, 20]", "8:43",
     "/materials/0/color_diffuse: colors end at 1: divide 200 20 20 by 255"),
    ('"color": [1, 1, 1]', '"color": [255, 255, 255]', "11:51",
     "/lights/0/color: white is 1 1 1: if this is in bytes, divide it by 255"),
    ('"use_diffuse_texture": true, ', "", "9:47",
     '/materials/1/diffuse_texture: not shown without "use_diffuse_texture": true'),
    ('"film_left": -0.5, "film_right": 0.5', '"film_left": 0.5, "film_right": -0.5', "4:22",
     "/camera/film_left: the picture is mirrored: swap it with film_right"),
    ('"film_bottom": -0.5, "film_top": 0.5', '"film_bottom": 0.5, "film_top": -0.5', "4:62",
     "/camera/film_bottom: the picture is upside down: swap it with film_top"),
    ('"look": [0, 0, -1], "up": [0, 1, 0]', '"look": [0, 0, -1.41421], "up": [0, 1, 1]', "2:15",
     "/camera: look and up distort: lengths 1.414, 1.414 at 135\u00b0, not 1, 1 at 90\u00b0"),
    ('"textures": {', '"textures": { "stone": "textures/wood.png",', "6:28",
     "/textures/stone: no diffuse_texture names it: name it, or delete it"),
    ('"translate"', '"rotation": 1, "translate"', "12:60",
     '/transforms/1: unknown key "rotation": write rotate, with degrees and an axis'),
    ('"shininess": 40', '"reflectivity": 0.5', "8:60",
     '/materials/0: unknown key "reflectivity"; did you mean "color_reflect"?'),
    ('"translate"', '"scaling": 1, "translate"', "12:60",
     '/transforms/1: unknown key "scaling"; did you mean "scale"?'),
    ('"translate"', '"position": 1, "translate"', "12:60",
     '/transforms/1: unknown key "position": delete it, there is "translate"'),
    ('"shininess"', '"texture"', "8:60",
     '/materials/0: unknown key "texture"; did you mean "diffuse_texture"?'),
    ('"shininess"', '"use_texture"', "8:60",
     '/materials/0: unknown key "use_texture"; did you mean "use_diffuse_texture"?'),
    ('"shininess"', '"ior"', "8:60",
     '/materials/0: unknown key "ior"; did you mean "index_of_refraction"?'),
    ('"film_left"', '"fov": 60, "film_left"', "4:9",
     '/camera: unknown key "fov": focal_length and film_left to film_top give the angle'),
    ('"type": "sphere"', '"radius": 1, "type": "sphere"', "14:11",
     '/shapes/0: unknown key "radius": scale in its transform gives the size'),
    ('"type": "sphere"', '"center": 1, "type": "sphere"', "14:11",
     '/shapes/0: unknown key "center": translate in its transform gives the place'),
    ('"type": "sphere"', '"color": 1, "type": "sphere"', "14:11",
     '/shapes/0: unknown key "color": its material has the colors'),
    ('"type": "cube"', '"type": "cube", "path": "a.obj"', "15:27",
     '/shapes/1: unknown key "path": only a mesh has one; delete it'),
    ("[0.8, 0.1, 0.1]", "[127.5, 127.5, 127.5]", "8:43",
     "/materials/0/color_diffuse: colors end at 1: divide 127.5 127.5 127.5 by 255"),
    ("[0.8, 0.1, 0.1]", "[300, 300, 300]", "8:43",
     "/materials/0/color_diffuse: colors end at 1: divide 300 300 300 by 255"),
    ('"color": [1, 1, 1]', '"color": [130, 130, 90.5]', "11:51",
     "/lights/0/color: white is 1 1 1: if this is in bytes, divide it by 255"),
    ('"color": [1, 1, 1]', '"color_ambient": [65535, 65535, 65535]', "11:59",
     "/lights/0/color_ambient: white is 1 1 1: if this is in 16 bits, divide it by 65535"),
    ("[0.8, 0.1, 0.1]", "[65535, 65535, 65535]", "8:43",
     "/materials/0/color_diffuse: colors end at 1: divide 65535 65535 65535 by 65535"),
    ("[0.8, 0.1, 0.1]", "[-0.8, 0.1, 0.1]", "8:43",
     "/materials/0/color_diffuse: a negative color takes light away: write 0 or more"),
    ('"focal_length": 1', '"focal_length": 35', "3:48",
     "/camera/focal_length: 35 is long for a film of 1: if in mm, write 0.9722"),
    ('"film_left"', '"look_at": [0, 0, 0], "film_left"', "4:9",
     '/camera: unknown key "look_at": look is the direction, the target minus the eye'),
    ('"color": [1', '"intensity": 2, "color": [1', "11:42",
     '/lights/0: unknown key "intensity": multiply its color by it'),
    ('"color_diffuse"', '"diffuse_color"', "8:26",
     '/materials/0: unknown key "diffuse_color"; did you mean "color_diffuse"?'),
    ('"shininess"', '"kd"', "8:60", '/materials/0: unknown key "kd": delete it, there is "color_diffuse"'),
    ('"shininess"', '"specular_exponent"', "8:60",
     '/materials/0: unknown key "specular_exponent"; did you mean "shininess"?'),
    ('"shininess"', '"mirror"', "8:60",
     '/materials/0: unknown key "mirror": reflective and color_reflect make a mirror'),
    ('"shininess"', '"glass"', "8:60",
     '/materials/0: unknown key "glass": refractive and color_refract make glass'),
    ('"shininess"', '"opacity"', "8:60",
     '/materials/0: unknown key "opacity": refractive and color_refract let light through'),
    ('"color": [1', '"location": 2, "color": [1', "11:42",
     '/lights/0: unknown key "location": delete it, there is "position"'),
    ('"translate"', '"degrees": 2, "translate"', "12:60",
     '/transforms/1: unknown key "degrees": it stands in rotate, beside an axis'),
    ('"type": "cube"', '"type": "cube", "scale": 2', "15:27",
     '/shapes/1: unknown key "scale": it stands in its transform'),
    ('"textures"', '"max_recursion": 2, "textures"', "6:5",
     'unknown key "max_recursion": it is the option --max-recursion'),
    ('"textures"', '"resolution": 2, "textures"', "6:5",
     'unknown key "resolution": LONG_EDGE_PIXELS of the command line gives it'),
]


def answered(folder, words):
    out = pathlib.Path(folder, "out.png")
    out.unlink(missing_ok=True)
    done = subprocess.run([RAYTRACER, *words], capture_output=True, text=True, cwd=folder, check=False,
                          timeout=60)
    lines = done.stderr.splitlines()
    if len(lines) > 3:
        failures.append(f"{words}: too much to read: {done.stderr}")
    for line in lines:
        check_width(words, line)
    check(f"{words}: a picture", done.returncode == 0, out.exists())
    return done.returncode, done.stdout, lines


def check_change(folder, change, status, lines, *options):
    before, after = change
    check(f"{before!r} stands in the scene", True, before in SCENE)
    pathlib.Path(folder, "scene.json").write_text(SCENE.replace(before, after, 1), encoding="utf-8")
    check(f"{after!r} for {before!r}, {options}", (status, "", lines), answered(folder, [*RENDER, *options]))


def check_all(folder):
    (folder / "textures").mkdir()
    (folder / "more").mkdir()
    shutil.copy("test/bad/files/check.png", folder / "textures/wood.png")
    shutil.copy("test/bad/files/check.png", folder / "reference.png")
    shutil.copy("test/bad/files/check.png", folder / "out.png")
    (folder / "graded").mkdir()
    (folder / "programs").mkdir()
    shutil.copy("test/bad/files/check.png", folder / "graded/scene.png")
    (folder / "graded/scene.json").write_text(SCENE.replace("textures/wood.png", "../textures/wood.png"),
                                              encoding="utf-8")
    (folder / "programs/raytracer").write_text("", encoding="utf-8")
    (folder / "more/other.json").write_text("{}", encoding="utf-8")
    (folder / "my scene.json").write_text("{}", encoding="utf-8")
    (folder / "refs").mkdir()
    shutil.copy("test/bad/files/check.png", folder / "refs/scene.png")
    (folder / "stages").mkdir()
    (folder / "stages/a.json").write_text(SCENE, encoding="utf-8")
    shutil.copy("test/bad/files/check.png", folder / "stages/a-diffuse.png")
    (folder / "programs/a.py").write_text("", encoding="utf-8")
    (folder / "class/ada").mkdir(parents=True)
    (folder / "class/ada/run").write_text("true", encoding="utf-8")
    (folder / "e").write_text("", encoding="utf-8")
    check_change(folder, ("red", "red"), 0, [])
    shutil.copy(folder / "out.png", folder / "small.png")
    here = os.path.realpath(folder)
    for line, answer in [(line, answer.replace("HERE", here)) for line, answer in COMMANDS]:
        if line[:7] == "compare":
            shutil.copy("test/bad/files/check.png", folder / "out.png")
            done = subprocess.run([RAYTRACER, *line.split()], capture_output=True, text=True, cwd=folder,
                                  check=False)
            check(line, (2, answer + "\n"), (done.returncode, done.stderr))
            check_width(line, answer)
            continue
        check(line, (2, "", [answer]), answered(folder, line if isinstance(line, list) else line.split()))
    for before, after, place, answer in SCENES:
        line, column = map(int, place.split(":"))
        text = SCENE.replace(before, after, 1).split("\n")[line - 1][:96]
        excerpt = ["    " + text, " " * (3 + column) + "^"]
        check_change(folder, (before, after), 2, [f"scene.json:{place}: {answer}", *excerpt])
    for before, after, place, answer in MEANINGS:
        check_change(folder, (before, after), 2, [f"scene.json:{place}: {answer}"])
    (folder / "scene.json").write_text(SCENE, encoding="utf-8")
    for assignment, answer in SETS:
        check(assignment,
              (2, "", [f"scene.json: {assignment.partition('=')[0]}, by --set: {answer}"]),
              answered(folder, [*RENDER, "--set", assignment]))
    for before, after, place, answer in WARNINGS:
        check_change(folder, (before, after), 0, [f"warning: scene.json:{place}: {answer}"])
        check_change(folder, (before, after), 2, [f"scene.json:{place}: {answer}"], "--strict", "--quiet")


def check_invisible(folder):
    """What nobody sees is named; what a terminal would obey is a mark in the excerpt."""
    film = SCENE.split("\n")[3]
    for character in "\f\v\u0085\u180e\u2028\u2029\u2800\u3164\ufe0f":
        shown = "?" if character in "\f\v\u0085\u2028\u2029" else character
        check_change(folder, ('"film_left"', character + '"film_left"'), 2,
                     [f"scene.json:4:9: an invisible character (U+{ord(character):04X}): delete it",
                      "    " + film.replace('"film_left"', shown + '"film_left"'), " " * 12 + "^"])


def check_places(folder):
    """What stands behind an edit is told where it stands in the file."""
    for edit in "/shapes/0/type=cylinder", "/camera/eye=[0,0,4.00]":
        check_change(folder, ('"material": "red"', '"material": "rde"'), 2,
                     ['scene.json:14:62: /shapes/0/material: no material named "rde"; did you mean "red"?'],
                     "--set", edit)


def check_texts(folder):
    """A text may have what would be a range, badly written, among numbers."""
    (folder / "scene.json").write_text(SCENE, encoding="utf-8")
    for edit in ['/materials/-={"name":"mat{1-2}"}', '/materials/-={"name": "1..2"}',
                 "/transforms/0/name={0}", "/textures/1..2=textures/wood.png",
                 "/textures/b=textures/../textures/wood.png"]:
        for options in [], ["--frames", "1..1"]:
            words = ["scene.json", "t-%d.png" if options else "out.png", "8", "--set", edit, *options]
            done = subprocess.run([RAYTRACER, *words], capture_output=True, text=True, cwd=folder,
                                  check=False)
            refusals = [line for line in done.stderr.splitlines() if "a range is" in line]
            check(f"{words}: a text", [], refusals)
    for name in "1..2", "mat{1}", "{0-1}":
        words = [*RENDER, "--set", f"/materials/0/name={name}", "--set", f"/shapes/0/material={name}"]
        check(f"a material named {name}", (0, "", []), answered(folder, words))


def check_black(folder):
    """A black picture: why, and what to change."""
    for changes, answer in [
            ([('"eye": [0, 0, 4]', '"eye": [0, 0, 0]')],
             "the camera is inside of /shapes/0, a sphere: move it out, or a light in"),
            ([("[3, 5, 4]", "[0, -1, -40]"), ("[0, -1, 0]", "[0, -9, 0]")],
             "what is seen faces no light: move one, or set /materials/0/color_ambient"),
            ([("[3, 5, 4]", "[0, 0, 400]"), ("[0, -1, 0]", "[0, 0, 9]")],
             "/shapes/1 shadows what is seen: move it, or set /materials/0/color_ambient"),
            ([('"lights": [ { "position": [3, 5, 4], "color": [1, 1, 1] } ]', '"lights": []')],
             'the scene has no lights: add one to "lights"'),
            ([('"color": [1, 1, 1]', '"color": [-1, -1, -1]')],
             "/lights/0/color is negative, which takes light away: write 0 or more"),
            ([('"color": [1, 1, 1]', '"color": [0.0001, 0, 0]')],
             "it is too dark: the largest channel is 7.46e-05 of 1: brighten a light")]:
        text = SCENE
        for before, after in changes:
            check(f"{before!r} stands in the scene", True, before in text)
            text = text.replace(before, after, 1)
        (folder / "scene.json").write_text(text, encoding="utf-8")
        check(answer, (0, "", [f"warning: scene.json: all black: {answer}"]),
              (lambda done: (*done[:2], done[2][-1:]))(answered(folder, RENDER)))


def check_several(folder):
    """--strict tells all faults before it ends; cost is none."""
    scene = json.loads(SCENE)
    scene["camera"]["comment"] = ""
    scene["lights"][0]["color"] = [255, 255, 255]
    (folder / "scene.json").write_text(json.dumps(scene), encoding="utf-8")
    status, _, lines = answered(folder, [*RENDER, "--strict"])
    check("two faults", (2, 2), (status, len(lines)))
    (folder / "scene.json").write_text(SCENE, encoding="utf-8")
    done = subprocess.run([RAYTRACER, "scene.json", "out.png", "60000", "--samples", "60000", "--crop",
                           "0,0,1,1", "--strict"],
                          capture_output=True, text=True, cwd=folder, check=False)
    check("cost, of one pixel", (0, ""), (done.returncode, done.stderr))


def check_names(folder):
    """What is proposed for a scene in another folder is the name to write into it."""
    (folder / "nf/textures").mkdir(parents=True)
    shutil.copy("test/bad/files/check.png", folder / "nf/textures/wood.png")
    (folder / "nf/balls.json").write_text(SCENE, encoding="utf-8")
    for written, found in [("nf/textures/wood.png", "textures/wood.png"),
                           ("textures/wod.png", "textures/wood.png"),
                           ("reference.png", "../reference.png")]:
        (folder / "nf/s.json").write_text(SCENE.replace("textures/wood.png", written), encoding="utf-8")
        check(written, (2, "", [f'nf/s.json:6:27: /textures/wood: no file "nf/{written}" (relative to the '
                                f'scene file); write "{found}"']),
              answered(folder, ["nf/s.json", "out.png", "8"]))
    for path, status, answer in [
            ("textures/wood.png", 2, '/dev/stdin:6:27: /textures/wood: no file "/dev/textures/wood.png": '
             "a scene from a pipe has no folder: write a path from the root\n"),
            (str(folder / "textures/wood.png"), 0, "")]:
        done = subprocess.run([RAYTRACER, "/dev/stdin", "out.png", "8"], capture_output=True, text=True,
                              input=SCENE.replace("textures/wood.png", path), cwd=folder, check=False)
        check(f"from a pipe: {path}", (status, answer), (done.returncode, done.stderr))
    for typed in ["ball.json", "blals.json"]:
        check(typed, (2, "", [f'{typed}: cannot read: No such file or directory; there is "nf/balls.json"']),
              answered(folder, [typed, "out.png", "8"]))


def check_cost(folder):
    """What takes long is told before it is begun."""
    glass = str(pathlib.Path("scenes/refraction.json").resolve())
    rays = f"warning: {glass}: --max-recursion 1000 takes about N rays a sample; lower it"
    for options, remedy in (([], ", or add a --cutoff"), (["--cutoff", "1e-99"], ""),
                            (["--set", "/materials/4/color_reflect=[0,0,1]", "--set",
                              "/materials/4/color_refract=[0,1,0]"], "")):
        words = [glass, "out.png", "20", "--max-recursion", "1000", "--crop", "0,0,1,1", *options]
        _, _, lines = answered(folder, words)
        check(f"{options}: rays", [rays + remedy],
              [re.sub("about [0-9.e+]+ rays", "about N rays", line) for line in lines])
    (folder / "scene.json").write_text(SCENE, encoding="utf-8")
    for options, said, units, instead in [
            (["--samples", "20000"], "of 20000 samples", "min|h|days", "--adaptive 0.02"),
            (["--adaptive", "1e-9"], "with --adaptive 1e-09", "min|h|days", "a smaller size"),
            (["--adaptive", "1e-9", "--samples", "65536"], "with --adaptive 1e-09", "h|days",
             "a smaller size")]:
        words = [RAYTRACER, "scene.json", "out.png", "8000", *options, "--threads", "1"]
        with subprocess.Popen(words, stderr=subprocess.PIPE, text=True, cwd=folder) as process:
            line = process.stderr.readline()
            process.kill()
        check("cost", f"warning: scene.json: 8000 × 8000 pixels {said} take about T; {instead} takes less\n",
              re.sub(f"about [0-9.]+ ({units});", "about T;", line))

    words = [RAYTRACER, "scene.json", "f-%d.png", "8", "--frames", "1..999999"]
    with subprocess.Popen(words, stderr=subprocess.PIPE, text=True, cwd=folder) as process:
        line = process.stderr.readline()
        process.kill()
    check("frames", "warning: scene.json: 999998 more frames take about T; a smaller size takes less\n",
          re.sub("about [0-9.]+ (min|h|days);", "about T;", line))


with tempfile.TemporaryDirectory() as temporary:
    check_all(pathlib.Path(temporary))
    check_invisible(pathlib.Path(temporary))
    check_places(pathlib.Path(temporary))
    check_texts(pathlib.Path(temporary))
    check_black(pathlib.Path(temporary))
    check_several(pathlib.Path(temporary))
    check_names(pathlib.Path(temporary))
    check_cost(pathlib.Path(temporary))
count = len(COMMANDS) + len(SCENES) + len(MEANINGS) + len(SETS) + len(WARNINGS)
sys.exit(conclude(f"{count} mistakes are answered"))
