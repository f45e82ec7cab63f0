# ms: five single-header C libraries. Plain make and a C compiler build the examples and make their pictures.
#   make            the examples, into build/
#   make demo       runs them: pictures and tables in build/demo/
#   make deps       installs what `make test` needs (OpenImageIO, Embree) with the system's package manager
#   make check      tests that need a C compiler only, a minute or two
#   make test       all tests
#   make bench      speed against error: tables and plots in build/bench/, peers where they are installed
#   make sanitize, check-style, thread, valgrind, fuzz, soak     other ways to run the tests
#   make test-cross other machines, each where its compiler and emulator are installed
#   make sizes      what each header adds to a program, in kilobytes
#   make dataset    path-traced pictures of random materials for training (FIRST, COUNT, SIZE, SAMPLES, TAKE, JOBS)
#   make hero       README's top picture: recommended materials on 209 objects, path-traced (WIDTH, HEIGHT, PASSES, JOBS)
#   make train      the networks of examples/data from nothing: hours (PyTorch)
#   make common     copies the block that all headers share from ms_mcml.h into the rest
.POSIX:

CC = cc
CXX = c++
CFLAGS = -O2
LDLIBS = -lm

TOOLS = build/mcml build/mcml_split build/profile build/sss_kernel build/sss_filter build/postprocess build/lightmap \
	build/recommend build/latent build/nn_info build/nn_run build/preview build/match build/workflow
DEMOS = build/demo_sss build/demo_match
IMAGE = examples/image.h
PLOT = examples/plot.h
BUILD = mkdir -p build && $(CC) -std=c99 $(CPPFLAGS) $(CFLAGS) -I. $(LDFLAGS) -o $@

all: $(TOOLS) $(DEMOS)

build/mcml: examples/mcml.c ms_mcml.h
	$(BUILD) examples/mcml.c $(LDLIBS)
build/mcml_split: examples/mcml_split.c ms_mcml.h
	$(BUILD) examples/mcml_split.c $(LDLIBS)
build/profile: examples/profile.c ms_mcml.h
	$(BUILD) examples/profile.c $(LDLIBS)
build/sss_kernel: examples/sss_kernel.c ms_sss.h ms_mcml.h
	$(BUILD) examples/sss_kernel.c $(LDLIBS)
build/sss_filter: examples/sss_filter.c ms_sss.h ms_mcml.h $(IMAGE)
	$(BUILD) examples/sss_filter.c $(LDLIBS)
build/postprocess: examples/postprocess.c ms_sss.h $(IMAGE)
	$(BUILD) examples/postprocess.c $(LDLIBS)
build/lightmap: examples/lightmap.c ms_sss.h $(IMAGE)
	$(BUILD) examples/lightmap.c $(LDLIBS)
build/demo_sss: examples/demo_sss.c examples/scene.h ms_sss.h ms_mcml.h $(IMAGE) $(PLOT)
	$(BUILD) examples/demo_sss.c $(LDLIBS)
build/recommend: examples/recommend.c examples/scores.h ms_gpr.h
	$(BUILD) examples/recommend.c $(LDLIBS)
build/latent: examples/latent.c examples/scores.h examples/maps.h ms_gpr.h $(IMAGE)
	$(BUILD) examples/latent.c $(LDLIBS)
build/nn_info: examples/nn_info.c ms_nn.h
	$(BUILD) examples/nn_info.c $(LDLIBS)
build/nn_run: examples/nn_run.c ms_nn.h
	$(BUILD) examples/nn_run.c $(LDLIBS)
build/preview: examples/preview.c examples/neural.h examples/materials.h ms_nn.h $(IMAGE)
	$(BUILD) examples/preview.c $(LDLIBS)
build/match: examples/match.c examples/matcher.h examples/neural.h examples/materials.h ms_nn.h ms_pme.h $(IMAGE)
	$(BUILD) examples/match.c $(LDLIBS)
build/demo_match: examples/demo_match.c examples/matcher.h examples/neural.h examples/edits.h ms_nn.h ms_pme.h $(IMAGE)
	$(BUILD) examples/demo_match.c $(LDLIBS)
build/workflow: examples/workflow.c examples/workflow.h examples/neural.h examples/scores.h examples/studio.h examples/matcher.h examples/materialx.h \
	examples/maps.h ms_gpr.h ms_nn.h ms_pme.h $(IMAGE)
	$(BUILD) examples/workflow.c $(LDLIBS)

demo: all
	@sh examples/demo.sh

deps:
	@sh tests/deps.sh

# The examples, two at a time, for the tests.
examples:
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
sizes:
	@CC="$(CC)" sh tests/dropin/sizes.sh
bench: all sizes
	@CC="$(CC)" CFLAGS="$(CFLAGS)" sh tests/bench/run.sh

dataset:
	@CC="$(CC)" sh tests/render/dataset.sh
hero: build/recommend
	@CC="$(CC)" sh tests/render/hero.sh
train:
	@CC="$(CC)" sh tests/train/train.sh

common:
	@sh tests/common.sh copy

clean:
	rm -rf build

.PHONY: all demo deps examples check test check-style sanitize thread valgrind fuzz soak test-cross sizes bench dataset hero train common clean
