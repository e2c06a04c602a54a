// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;

namespace PhonemeEar
{
    /// <summary>Guesses which blend shape of a face stands for a movestate, by what programs call them.</summary>
    public sealed class ShapeGuess
    {
        private static readonly string[] Noise = { "blendshape", "blendshapes", "bs", "expression", "face", "fcl", "head", "morph", "shape" };
        private readonly Dictionary<string, string[]> alternatives = new Dictionary<string, string[]>();

        /// <summary>Take the lines of shape_names.txt: a movestate without its side, "=", and what programs call it.</summary>
        public ShapeGuess(string lines)
        {
            foreach (var line in lines.Split('\n').Where(line => line.Contains("=")))
            {
                var parts = line.Split('=');
                alternatives[parts[0].Trim()] = parts[1].Split(' ').Select(word => word.Trim()).Where(word => word.Length > 0).ToArray();
            }
        }

        /// <summary>The name that stands for a movestate such as "mouthSmileLeft"; empty where none does.</summary>
        public string For(string movestate, IReadOnlyList<string> names)
        {
            var side = movestate.EndsWith("Left") ? "l" : movestate.EndsWith("Right") ? "r" : "";
            var stem = alternatives.ContainsKey(movestate) || side == "" ? movestate : movestate.Substring(0, movestate.Length - (side == "l" ? 4 : 5));
            if (stem == movestate)
                side = ""; // jawLeft: a direction, not a side of the face
            var known = alternatives.TryGetValue(stem, out var words) ? words : new string[0];
            foreach (var word in new[] { Key(stem).Item1 }.Concat(known))
                foreach (var name in names)
                    if (Key(name).Equals((word, side)) || (side == "" && Key(name).Item1 + Full(Key(name).Item2) == word))
                        return name;
            return "";
        }

        private static string Full(string side) => side == "l" ? "left" : side == "r" ? "right" : "";

        /// <summary>The letters and digits of a name in lower case without its side, and the side: l, r, or empty.</summary>
        private static (string, string) Key(string name)
        {
            var dot = name.LastIndexOf('.');
            name = name.Substring(dot < name.Length - 2 ? dot + 1 : 0); // head_blendShape.jawOpen, not eye.L
            var words = Regex.Matches(name, "[A-Z]+(?![a-z])|[A-Z]?[a-z]+|[0-9]+").Cast<Match>().Select(match => match.Value.ToLowerInvariant());
            var kept = words.Where(word => Array.IndexOf(Noise, word) < 0).ToList();
            var side = kept.Find(word => word == "l" || word == "left" || word == "r" || word == "right") ?? "";
            kept.Remove(side);
            return (string.Concat(kept), side == "" ? "" : side.Substring(0, 1));
        }
    }
}
