# ms: five single-header C libraries. Plain make and a C compiler build the examples and make their pictures.
#   make            the examples, into build/
#   make demo       runs them: pictures and tables in build/demo/
#   make deps       installs what `make test` needs (OpenImageIO, Embree) with the system's package manager
#   make check      tests that need a C compiler only, a minute or two
#   make test       all tests
#   make bench      speed against error: tables and plots in build/bench/, peers where they are installed
#   make bench-gpu  milliseconds of the shaders on this machine's GPU (EGL)
#   make sanitize, check-style, thread, valgrind, fuzz, soak     other ways to run the tests
#   make mutate    do the tests notice when a line changes? (HEADER, COUNT, SEED)
#   make coverage  lines and branches that the tests of each header reach (gcov)
#   make calls     stack, traps and flushed subnormals of every public call
#   make test-cross other machines, each where its compiler and emulator are installed
#   make sizes      what each header adds to a program, in kilobytes
#   make dataset    path-traced pictures of random materials for training (FIRST, COUNT, SIZE, SAMPLES, TAKE, JOBS)
#   make hero       README's top picture: recommended materials on 209 objects, path-traced (WIDTH, HEIGHT, PASSES, JOBS)
#   make train      the networks of examples/data from nothing: hours of rendering, an hour of training
#   make web        examples/web/kernels.html: subsurface kernels designed live in a browser (clang for WebAssembly, wasi-libc)
#   make studio     examples/web/studio.html: the whole workflow live in a browser (the same)
#   make common     copies the blocks that headers share from the first that has them into the rest
.POSIX:

CC = cc
CXX = c++
CFLAGS = -O2
LDLIBS = -lm

# Every implementation is compiled once; the examples are told that it is there and link what they use. (Each also
# compiles alone, as its comment says.)
TOOLS = build/mcml build/mcml_split build/profile build/sss_kernel build/sss_filter build/postprocess build/lightmap \
	build/recommend build/latent build/nn_info build/nn_run build/nn_quantise build/preview build/match build/materialx build/workflow build/train build/own_shader
DEMOS = build/demo_sss build/demo_match
OBJECTS = build/ms_mcml.o build/ms_sss.o build/ms_gpr.o build/ms_nn.o build/ms_pme.o build/image.o
MADE = -DMS_MCML_IMPLEMENTED -DMS_SSS_IMPLEMENTED -DMS_GPR_IMPLEMENTED -DMS_NN_IMPLEMENTED -DMS_PME_IMPLEMENTED -DIMAGE_IMPLEMENTED
IMAGE = examples/image.h examples/files.h build/image.o
PLOT = examples/plot.h
COMPILE = $(CC) -std=c99 $(CPPFLAGS) $(CFLAGS) -I.
OBJECT = @mkdir -p build && echo "compiling $@" && $(COMPILE) -c -o $@ -x c /dev/null
BUILD = @echo "linking $@" && $(COMPILE) $(MADE) $(LDFLAGS) -o $@

all: $(TOOLS) $(DEMOS)

build/ms_mcml.o: ms_mcml.h
	$(OBJECT) -DMS_MCML_IMPLEMENTATION -include ms_mcml.h
build/ms_sss.o: ms_sss.h
	$(OBJECT) -DMS_SSS_IMPLEMENTATION -include ms_sss.h
build/ms_gpr.o: ms_gpr.h
	$(OBJECT) -DMS_GPR_IMPLEMENTATION -include ms_gpr.h
build/ms_nn.o: ms_nn.h
	$(OBJECT) -DMS_NN_IMPLEMENTATION -include ms_nn.h
build/ms_pme.o: ms_pme.h
	$(OBJECT) -DMS_PME_IMPLEMENTATION -include ms_pme.h
build/image.o: examples/image.h examples/files.h
	$(OBJECT) -DIMAGE_DEF= -include examples/image.h

build/mcml: examples/mcml.c build/ms_mcml.o
	$(BUILD) examples/mcml.c build/ms_mcml.o $(LDLIBS)
build/mcml_split: examples/mcml_split.c build/ms_mcml.o
	$(BUILD) examples/mcml_split.c build/ms_mcml.o $(LDLIBS)
build/profile: examples/profile.c build/ms_mcml.o
	$(BUILD) examples/profile.c build/ms_mcml.o $(LDLIBS)
build/sss_kernel: examples/sss_kernel.c build/ms_sss.o build/ms_mcml.o
	$(BUILD) examples/sss_kernel.c build/ms_sss.o build/ms_mcml.o $(LDLIBS)
build/sss_filter: examples/sss_filter.c $(IMAGE) build/ms_sss.o build/ms_mcml.o
	$(BUILD) examples/sss_filter.c build/ms_sss.o build/ms_mcml.o build/image.o $(LDLIBS)
build/postprocess: examples/postprocess.c $(IMAGE) build/ms_sss.o
	$(BUILD) examples/postprocess.c build/ms_sss.o build/image.o $(LDLIBS)
build/lightmap: examples/lightmap.c $(IMAGE) build/ms_sss.o
	$(BUILD) examples/lightmap.c build/ms_sss.o build/image.o $(LDLIBS)
build/demo_sss: examples/demo_sss.c examples/scene.h $(IMAGE) $(PLOT) build/ms_sss.o build/ms_mcml.o
	$(BUILD) examples/demo_sss.c build/ms_sss.o build/ms_mcml.o build/image.o $(LDLIBS)
build/recommend: examples/recommend.c examples/keep.h examples/scores.h build/ms_gpr.o
	$(BUILD) examples/recommend.c build/ms_gpr.o $(LDLIBS)
build/latent: examples/latent.c examples/scores.h examples/maps.h examples/text.h examples/neural.h $(IMAGE) build/ms_gpr.o build/ms_nn.o
	$(BUILD) examples/latent.c build/ms_gpr.o build/ms_nn.o build/image.o $(LDLIBS)
build/nn_info: examples/nn_info.c build/ms_nn.o
	$(BUILD) examples/nn_info.c build/ms_nn.o $(LDLIBS)
build/nn_run: examples/nn_run.c build/ms_nn.o
	$(BUILD) examples/nn_run.c build/ms_nn.o $(LDLIBS)
build/nn_quantise: examples/nn_quantise.c examples/files.h build/ms_nn.o
	$(BUILD) examples/nn_quantise.c build/ms_nn.o $(LDLIBS)
build/preview: examples/preview.c examples/neural.h examples/materials.h $(IMAGE) build/ms_nn.o
	$(BUILD) examples/preview.c build/ms_nn.o build/image.o $(LDLIBS)
build/materialx: examples/materialx.c examples/materialx.h examples/materials.h examples/files.h
	$(BUILD) examples/materialx.c $(LDLIBS)
build/train: examples/train.c examples/train.h $(IMAGE) build/ms_nn.o
	$(BUILD) -O3 -fno-math-errno -fno-trapping-math -D_POSIX_C_SOURCE=200809L examples/train.c build/ms_nn.o build/image.o $(LDLIBS) -lpthread
build/own_shader: examples/own_shader.c $(IMAGE)
	$(BUILD) examples/own_shader.c build/image.o $(LDLIBS)
build/match: examples/match.c examples/matcher.h examples/neural.h examples/materials.h $(IMAGE) build/ms_nn.o build/ms_pme.o
	$(BUILD) examples/match.c build/ms_nn.o build/ms_pme.o build/image.o $(LDLIBS)
build/demo_match: examples/demo_match.c examples/matcher.h examples/neural.h examples/edits.h examples/text.h $(IMAGE) build/ms_nn.o build/ms_pme.o
	$(BUILD) examples/demo_match.c build/ms_nn.o build/ms_pme.o build/image.o $(LDLIBS)
build/workflow: examples/workflow.c examples/workflow.h examples/neural.h examples/scores.h examples/studio.h \
	examples/matcher.h examples/materialx.h examples/maps.h examples/text.h $(IMAGE) build/ms_gpr.o build/ms_nn.o build/ms_pme.o
	$(BUILD) examples/workflow.c build/ms_gpr.o build/ms_nn.o build/ms_pme.o build/image.o $(LDLIBS)

# What it runs, no more; `make` builds the rest.
demo: build/profile build/sss_kernel build/demo_sss build/recommend build/latent build/preview build/demo_match build/workflow
	@sh examples/demo.sh

deps:
	@sh tests/deps.sh

# The examples, two at a time, for the tests: the objects first, which several of them link.
examples:
	@printf '%s\n' $(OBJECTS) | xargs -n 1 -P $${JOBS:-2} $(MAKE) -s
	@printf '%s\n' $(TOOLS) $(DEMOS) | xargs -n 1 -P $${JOBS:-2} $(MAKE) -s

RUN = CC="$(CC)" CXX="$(CXX)" CFLAGS="$(CFLAGS)" sh tests/run.sh
check: examples
	@$(RUN) check
test: examples
	@$(RUN) test
check-style:
	@$(RUN) style
sanitize:
	@$(RUN) sanitize
thread:
	@$(RUN) thread
valgrind:
	@$(RUN) valgrind
fuzz:
	@$(RUN) fuzz
soak:
	@$(RUN) soak
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

# Of OpenGL through EGL; not among the examples that need a C compiler only.
build/engine: examples/gl/engine.c examples/gl/egl.h $(IMAGE) ms_sss.h
	@mkdir -p build && $(COMPILE) -Iexamples -o $@ examples/gl/engine.c -lEGL $(LDLIBS)
build/previews: examples/gl/previews.c examples/gl/egl.h examples/neural.h $(IMAGE) ms_nn.h
	@mkdir -p build && $(COMPILE) -Iexamples -o $@ examples/gl/previews.c -lEGL $(LDLIBS)
build/bench_gpu: tests/bench/gpu_sss.c examples/gl/egl.h tests/bench/bench.h ms_sss.h
	@mkdir -p build && $(COMPILE) -D_POSIX_C_SOURCE=200809L -Iexamples -Itests/bench -o $@ tests/bench/gpu_sss.c -lEGL $(LDLIBS)
bench-gpu: build/bench_gpu
	@build/bench_gpu

web:
	@CC="$(CC)" sh examples/web/build.sh kernels examples/web/kernels.html
studio:
	@CC="$(CC)" sh examples/web/build.sh studio examples/web/studio.html

dataset:
	@CC="$(CC)" sh tests/render/dataset.sh
hero: build/recommend
	@CC="$(CC)" sh tests/render/hero.sh
train: build/train
	@CC="$(CC)" sh tests/train/train.sh

common:
	@sh tests/common.sh copy

clean:
	rm -rf build

.PHONY: all demo deps examples check test check-style sanitize thread valgrind fuzz soak test-cross mutate coverage calls sizes bench bench-gpu web studio dataset hero train common clean
