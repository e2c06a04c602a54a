// SPDX-License-Identifier: MIT
using System;
using UnityEngine;

namespace PhonemeEar
{
    /// <summary>What PhonemeAnalyser exports as curves-json: the weights of movestates over time.</summary>
    [Serializable]
    public sealed class Curves
    {
        private const string Format = "phonemeanalyser curves 1";

        [Serializable]
        public sealed class Curve
        {
            public string name;
            public float[] values;
        }

        public string format;
        /// <summary>Seconds.</summary>
        public float duration;
        /// <summary>Values a second.</summary>
        public float rate;
        public Curve[] curves = new Curve[0];

        /// <summary>Read the text of a file.</summary>
        public static Curves Read(string text)
        {
            Curves found = null;
            try
            {
                found = JsonUtility.FromJson<Curves>(text);
            }
            catch (ArgumentException)
            {
                // it is no JSON
            }
            if (found == null || found.format != Format || found.rate <= 0 || found.curves == null)
                throw new EarException("these are no curves; export the sound with --format curves-json");
            return found;
        }

        /// <summary>The weight of a curve at a time in seconds, 0..1.</summary>
        public float At(Curve curve, double time)
        {
            if (curve.values == null || curve.values.Length == 0)
                return 0;
            var place = Math.Max(0, Math.Min(time * rate, curve.values.Length - 1));
            var before = (int)place;
            var after = Math.Min(before + 1, curve.values.Length - 1);
            return (float)(curve.values[before] + (place - before) * (curve.values[after] - curve.values[before]));
        }
    }
}
