# scripts/demo on Debian: docker build -t ariadne . && docker run --rm -v "$PWD/out:/ariadne/out" ariadne
FROM debian:bookworm
WORKDIR /ariadne
COPY scripts/install-dependencies scripts/
RUN scripts/install-dependencies && rm -rf /var/lib/apt/lists/*
COPY . .
RUN scripts/build programs
CMD ["scripts/demo"]
