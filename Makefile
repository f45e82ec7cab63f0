# ms: five single-header C libraries. Plain make and a C compiler build the examples and make their pictures.
#   make            the examples, into build/
#   make demo       runs them: pictures and tables in build/demo/
#   make deps       installs what `make test` needs (OpenImageIO, Embree; BLENDER=1: Blender) with the package manager
#   make check      tests that need a C compiler only, a minute and a half
#   make test       tests of every header, example and page, eight minutes
#   make test-long  what make test leaves out, for releases: longer versions, more builds
#   make bench      speed against error: tables and plots in build/bench/, peers where they are installed
#   make bench-gpu  milliseconds of the shaders on this machine's GPU (EGL)
#   make format     the layout of all C files by clang-format 14 (make check-style checks it)
#   make attack     random valid calls of every header with a fresh seed, under sanitizers (SECONDS of processor time: 600)
#   make sanitize, check-style, thread, valgrind, fuzz, soak     other ways to run the tests
#   make mutate    do the tests notice when a line changes? (HEADER, COUNT, SEED)
#   make coverage  lines and branches that the tests of each header reach (gcov)
#   make calls     stack, traps and flushed subnormals of every public call
#   make test-cross other machines, each where its compiler and emulator are installed
#   make sizes      what each header adds to a program, in kilobytes
#   make dataset    path-traced pictures of random materials for training (FIRST, COUNT, SIZE, SAMPLES, TAKE, JOBS)
#   make hero       README's top picture: recommended materials on 209 objects, path-traced (WIDTH, HEIGHT, PASSES, JOBS)
#   make portrait   README's head of skin: without scattering, by ms_sss.h, path-traced; and a loop (WALKS, FRAMES, ONLY)
#   make train      the networks of examples/data from nothing: hours of rendering, an hour of training
#   make web        examples/web/: kernels.html, subsurface kernels designed live in a browser; three.html, babylon.html (clang for WebAssembly, wasi-libc; make deps)
#   make studio     examples/web/studio.html: the whole workflow live in a browser (the same)
#   make blender    build/material_taste: an add-on for Blender that learns a taste (examples/blender)
#   make blender-dataset, blender-train   its network again, from pictures by Blender's Cycles (COUNT, SAMPLES, JOBS)
#   make wgsl       examples/engine/shader/*.wgsl from ms_sss.glsl
#   make common     copies the blocks that headers share from the first that has them into the rest
.POSIX:

CC = cc
CXX = c++
CFLAGS = -O2
LDLIBS = -lm

# Every implementation is compiled once; the examples are told that it is there and link what they use. (Each also
# compiles alone, as its comment says.)
TOOLS = build/mcml build/profile build/sss_kernel build/sss_filter build/postprocess build/lightmap \
	build/recommend build/latent build/nn_info build/nn_run build/nn_quantize build/preview build/match build/materialx build/workflow build/train build/own_shader build/sss_wgsl
SMALL = build/ms_mcml build/ms_sss build/ms_gpr build/ms_nn build/ms_pme
DEMOS = build/demo_sss build/demo_match
OBJECTS = build/ms_mcml.o build/ms_sss.o build/ms_gpr.o build/ms_nn.o build/ms_pme.o build/image.o
MADE = -DMS_MCML_IMPLEMENTED -DMS_SSS_IMPLEMENTED -DMS_GPR_IMPLEMENTED -DMS_NN_IMPLEMENTED -DMS_PME_IMPLEMENTED -DIMAGE_IMPLEMENTED
IMAGE = examples/tools/image.h examples/tools/files.h build/image.o
PLOT = examples/demo/plot.h
COMPILE = $(CC) -std=c99 $(CPPFLAGS) $(CFLAGS) -I.
OBJECT = @mkdir -p build && echo "compiling $@" && $(COMPILE) -c -o $@ -x c /dev/null
BUILD = @echo "linking $@" && $(COMPILE) $(MADE) $(LDFLAGS) -o $@

all: $(SMALL) $(TOOLS) $(DEMOS)

build/ms_mcml.o: ms_mcml.h
	$(OBJECT) -DMS_MCML_IMPLEMENTATION -include ms_mcml.h
build/ms_sss.o: ms_sss.h # with plain C, which the tests compare the SIMD levels with
	$(OBJECT) -DMS_SSS_IMPLEMENTATION -DMS_SSS_WITH_SCALAR -include ms_sss.h
build/ms_gpr.o: ms_gpr.h
	$(OBJECT) -DMS_GPR_IMPLEMENTATION -include ms_gpr.h
build/ms_nn.o: ms_nn.h
	$(OBJECT) -DMS_NN_IMPLEMENTATION -include ms_nn.h
build/ms_pme.o: ms_pme.h
	$(OBJECT) -DMS_PME_IMPLEMENTATION -include ms_pme.h
build/image.o: examples/tools/image.h examples/tools/files.h
	$(OBJECT) -DIMAGE_DEF= -include examples/tools/image.h

# One program a header.
build/ms_mcml: examples/ms_mcml.c build/ms_mcml.o
	$(BUILD) examples/ms_mcml.c build/ms_mcml.o $(LDLIBS)
build/ms_sss: examples/ms_sss.c build/ms_sss.o
	$(BUILD) examples/ms_sss.c build/ms_sss.o $(LDLIBS)
build/ms_gpr: examples/ms_gpr.c build/ms_gpr.o
	$(BUILD) examples/ms_gpr.c build/ms_gpr.o $(LDLIBS)
build/ms_nn: examples/ms_nn.c build/ms_nn.o
	$(BUILD) examples/ms_nn.c build/ms_nn.o $(LDLIBS)
build/ms_pme: examples/ms_pme.c build/ms_pme.o
	$(BUILD) examples/ms_pme.c build/ms_pme.o $(LDLIBS)

build/mcml: examples/tools/mcml.c examples/tools/mci.h examples/tools/tally.h examples/tools/layered.h examples/tools/files.h build/ms_mcml.o
	$(BUILD) examples/tools/mcml.c build/ms_mcml.o $(LDLIBS)
build/profile: examples/tools/profile.c examples/tools/mci.h examples/tools/layered.h examples/tools/skin.h examples/tools/photon_profile.h examples/tools/files.h build/ms_mcml.o
	$(BUILD) examples/tools/profile.c build/ms_mcml.o $(LDLIBS)
build/sss_kernel: examples/tools/sss_kernel.c build/ms_sss.o build/ms_mcml.o
	$(BUILD) examples/tools/sss_kernel.c build/ms_sss.o build/ms_mcml.o $(LDLIBS)
build/sss_filter: examples/tools/sss_filter.c $(IMAGE) build/ms_sss.o build/ms_mcml.o
	$(BUILD) examples/tools/sss_filter.c build/ms_sss.o build/ms_mcml.o build/image.o $(LDLIBS)
build/postprocess: examples/engine/postprocess.c $(IMAGE) build/ms_sss.o
	$(BUILD) examples/engine/postprocess.c build/ms_sss.o build/image.o $(LDLIBS)
build/lightmap: examples/engine/lightmap.c $(IMAGE) build/ms_sss.o
	$(BUILD) examples/engine/lightmap.c build/ms_sss.o build/image.o $(LDLIBS)
build/sss_wgsl: examples/tools/sss_wgsl.c examples/tools/wgsl.h examples/tools/files.h
	$(BUILD) examples/tools/sss_wgsl.c $(LDLIBS)
build/demo_sss: examples/demo/demo_sss.c examples/demo/scene.h examples/tools/layered.h examples/tools/skin.h $(IMAGE) $(PLOT) build/ms_sss.o build/ms_mcml.o
	$(BUILD) examples/demo/demo_sss.c build/ms_sss.o build/ms_mcml.o build/image.o $(LDLIBS)
build/recommend: examples/tools/recommend.c examples/tools/explain.h examples/tools/warnings.h examples/tools/keep.h examples/tools/space.h examples/tools/scores.h build/ms_gpr.o
	$(BUILD) examples/tools/recommend.c build/ms_gpr.o $(LDLIBS)
build/latent: examples/tools/latent.c examples/tools/scores.h examples/tools/maps.h examples/tools/plane.h examples/tools/text.h examples/tools/neural.h $(IMAGE) build/ms_gpr.o build/ms_nn.o
	$(BUILD) examples/tools/latent.c build/ms_gpr.o build/ms_nn.o build/image.o $(LDLIBS)
build/nn_info: examples/tools/nn_info.c build/ms_nn.o
	$(BUILD) examples/tools/nn_info.c build/ms_nn.o $(LDLIBS)
build/nn_run: examples/tools/nn_run.c build/ms_nn.o
	$(BUILD) examples/tools/nn_run.c build/ms_nn.o $(LDLIBS)
build/nn_quantize: examples/tools/nn_quantize.c examples/tools/files.h build/ms_nn.o
	$(BUILD) examples/tools/nn_quantize.c build/ms_nn.o $(LDLIBS)
build/preview: examples/tools/preview.c examples/tools/neural.h examples/tools/materials.h $(IMAGE) build/ms_nn.o
	$(BUILD) examples/tools/preview.c build/ms_nn.o build/image.o $(LDLIBS)
build/materialx: examples/tools/materialx.c examples/tools/materialx.h examples/tools/materials.h examples/tools/files.h
	$(BUILD) examples/tools/materialx.c $(LDLIBS)
build/train: examples/tools/train.c examples/tools/train.h $(IMAGE) build/ms_nn.o
	$(BUILD) -O3 -fno-math-errno -fno-trapping-math -D_POSIX_C_SOURCE=200809L examples/tools/train.c build/ms_nn.o build/image.o $(LDLIBS) -lpthread
build/own_shader: examples/tools/own_shader.c $(IMAGE)
	$(BUILD) examples/tools/own_shader.c build/image.o $(LDLIBS)
build/match: examples/tools/match.c examples/tools/matcher.h examples/tools/neural.h examples/tools/materials.h $(IMAGE) build/ms_nn.o build/ms_pme.o
	$(BUILD) examples/tools/match.c build/ms_nn.o build/ms_pme.o build/image.o $(LDLIBS)
build/demo_match: examples/demo/demo_match.c examples/tools/matcher.h examples/tools/neural.h examples/demo/edits.h examples/tools/text.h $(IMAGE) build/ms_nn.o build/ms_pme.o
	$(BUILD) examples/demo/demo_match.c build/ms_nn.o build/ms_pme.o build/image.o $(LDLIBS)
build/workflow: examples/tools/workflow.c examples/tools/workflow.h examples/tools/neural.h examples/tools/scores.h examples/tools/studio.h examples/tools/warnings.h examples/tools/space.h \
	examples/tools/matcher.h examples/tools/materialx.h examples/tools/maps.h examples/tools/plane.h examples/tools/text.h $(IMAGE) build/ms_gpr.o build/ms_nn.o build/ms_pme.o
	$(BUILD) examples/tools/workflow.c build/ms_gpr.o build/ms_nn.o build/ms_pme.o build/image.o $(LDLIBS)

# What it runs, no more; `make` builds the rest.
demo: build/profile build/sss_kernel build/demo_sss build/recommend build/latent build/preview build/demo_match build/workflow
	@sh examples/demo/demo.sh

deps:
	@sh tests/deps.sh

# The examples, two at a time, for the tests: the objects first, which several of them link.
examples:
	@printf '%s\n' $(OBJECTS) | xargs -n 1 -P $${JOBS:-2} $(MAKE) -s
	@printf '%s\n' $(SMALL) $(TOOLS) $(DEMOS) | xargs -n 1 -P $${JOBS:-2} $(MAKE) -s

RUN = CC="$(CC)" CXX="$(CXX)" CFLAGS="$(CFLAGS)" sh tests/run.sh
check: examples
	@$(RUN) check
test: examples
	@$(RUN) test
test-long: examples
	@$(RUN) long
check-style:
	@$(RUN) style
format:
	@clang-format --version 2>/dev/null | grep -q 'version 14\.' || { echo "make format needs clang-format 14"; exit 1; }
	@git ls-files '*.c' '*.h' | xargs clang-format -i
sanitize: examples
	@$(RUN) sanitize
thread: examples
	@$(RUN) thread
valgrind: examples
	@$(RUN) valgrind
fuzz:
	@$(RUN) fuzz
soak:
	@$(RUN) soak
SECONDS = 600
attack:
	@ATTACK_SECONDS=$(SECONDS) $(RUN) attack
test-cross:
	@$(RUN) cross
mutate:
	@python3 tests/mutate.py $${HEADER:-ms_pme.h} --count $${COUNT:-20} --seed $${SEED:-1} --jobs $${JOBS:-2}
coverage:
	@sh tests/coverage.sh $${HEADER:-}
calls:
	@$(RUN) calls
sizes:
	@CC="$(CC)" sh tests/dropin/sizes.sh
bench: all sizes
	@CC="$(CC)" CFLAGS="$(CFLAGS)" sh tests/bench/run.sh

# Of OpenGL through EGL; not among the examples that need a C compiler only. The shader file as a list of bytes, as xxd -i prints it.
build/ms_sss.glsl.inc: examples/engine/shader/ms_sss.glsl
	@mkdir -p build && od -An -v -tu1 examples/engine/shader/ms_sss.glsl | tr -s ' \n' ',,' | sed 's/^,//; s/,$$//' >$@ && echo >>$@
build/engine: examples/engine/engine.c examples/engine/egl.h build/ms_sss.glsl.inc $(IMAGE) ms_sss.h
	@mkdir -p build && $(COMPILE) -Ibuild -Iexamples/tools -Iexamples/demo -Iexamples/engine -o $@ examples/engine/engine.c -lEGL $(LDLIBS)
build/previews: examples/engine/previews.c examples/engine/nn_shader.h examples/engine/egl.h examples/tools/neural.h $(IMAGE) ms_nn.h
	@mkdir -p build && $(COMPILE) -Iexamples/tools -Iexamples/demo -Iexamples/engine -o $@ examples/engine/previews.c -lEGL $(LDLIBS)
build/bench_gpu: tests/bench/gpu_sss.c tests/sss_shader.h examples/engine/disc.h examples/tools/wgsl.h examples/engine/egl.h tests/bench/bench.h ms_sss.h
	@mkdir -p build && $(COMPILE) -D_POSIX_C_SOURCE=200809L -Itests -Iexamples/tools -Iexamples/demo -Iexamples/engine -Itests/bench -o $@ tests/bench/gpu_sss.c -lEGL $(LDLIBS)
bench-gpu: build/bench_gpu
	@build/bench_gpu

web:
	@CC="$(CC)" sh examples/web/build.sh kernels examples/web/kernels.html
	@CC="$(CC)" sh examples/web/build.sh three examples/web/three.html
	@CC="$(CC)" sh examples/web/build.sh babylon examples/web/babylon.html
studio:
	@CC="$(CC)" sh examples/web/build.sh studio examples/web/studio.html

dataset:
	@CC="$(CC)" sh tests/render/dataset.sh
hero: build/recommend
	@CC="$(CC)" sh tests/render/hero.sh
portrait:
	@CC="$(CC)" sh tests/render/portrait.sh
train: build/train
	@CC="$(CC)" sh tests/train/train.sh

blender:
	@CC="$(CC)" sh examples/blender/build.sh addon
blender-dataset:
	@sh examples/blender/build.sh dataset
blender-train: build/train
	@sh examples/blender/build.sh train

common:
	@sh tests/common.sh copy
wgsl: build/sss_wgsl
	@build/sss_wgsl examples/engine/shader

clean:
	rm -rf build

.PHONY: all demo deps examples check test test-long check-style format sanitize thread valgrind fuzz soak attack test-cross mutate coverage calls sizes bench bench-gpu web studio dataset hero portrait train blender blender-dataset blender-train common wgsl clean
