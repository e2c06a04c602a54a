// SPDX-License-Identifier: MIT
using Godot;

namespace PhonemeEar
{
    /// <summary>Listens to an audio bus that has the effect Capture: that of a microphone, or of a voice.</summary>
    public abstract partial class EarListener : Node
    {
        /// <summary>An .ear file.</summary>
        [Export(PropertyHint.File, "*.ear")] public string Preset = "res://addons/phoneme_ear/preset.ear";

        /// <summary>The bus with the effect Capture.</summary>
        [Export] public string Bus = "Voice";

        private AudioEffectCapture capture;
        private Ear ear;
        private float[] mono = new float[0];
        private Frame[] frames = new Frame[0];

        /// <summary>A mouth table that was shipped with the preset.</summary>
        public abstract string TableName { get; }

        /// <summary>What was recognised last.</summary>
        public Frame Newest { get; private set; }

        protected EarModel Model { get; private set; }
        protected int TableNumber { get; private set; }

        static EarListener() => EarLibrary.Find();

        public override void _Ready()
        {
            try
            {
                Open();
            }
            catch (EarException error)
            {
                GD.PushError($"{Name}: {error.Message}");
                SetProcess(false);
            }
        }

        public override void _ExitTree()
        {
            ear?.Dispose();
            Model?.Dispose();
            ear = null;
            Model = null;
        }

        public override void _Process(double delta)
        {
            var n = Mathf.Min(capture.GetFramesAvailable(), mono.Length);
            if (n == 0)
                return;
            var stereo = capture.GetBuffer(n);
            for (var k = 0; k < n; k++)
                mono[k] = (stereo[k].X + stereo[k].Y) / 2;
            var found = ear.Push(mono, n, frames);
            for (var k = 0; k < found; k++)
                Hear(Newest = frames[k]);
        }

        /// <summary>Take a frame.</summary>
        protected abstract void Hear(in Frame frame);

        /// <summary>What else is opened when the preset is there.</summary>
        protected abstract void Begin();

        private void Open()
        {
            var bus = AudioServer.GetBusIndex(Bus);
            for (var k = 0; bus >= 0 && k < AudioServer.GetBusEffectCount(bus); k++)
                capture = capture ?? AudioServer.GetBusEffect(bus, k) as AudioEffectCapture;
            if (capture == null)
                throw new EarException($"there is no bus {Bus} with the effect Capture; add them in the Audio panel");
            var bytes = FileAccess.GetFileAsBytes(Preset);
            if (bytes.Length == 0)
                throw new EarException($"{Preset} cannot be read; check its name, and that *.ear is exported");
            Model = new EarModel(bytes);
            TableNumber = Model.FindTable(TableName);
            var rate = (int)AudioServer.GetMixRate();
            ear = new Ear(Model, rate);
            mono = new float[rate / 2];
            frames = new Frame[ear.MostFrames(mono.Length)];
            Begin();
        }
    }
}
