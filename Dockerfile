# telar serve in a container: debian-slim, no root, Mesa's software GL. js/docs/container.md has how to run it, read-only and on a GPU.
#   docker build -t telar .
# compiles for some minutes. With what `npm run package` wrote already, nothing is compiled:
#   docker build -t telar --build-context packages=out/package .

ARG NODE=24

# What compiles. It never reaches the image.
FROM node:${NODE}-bookworm AS build
WORKDIR /src
COPY . .
RUN npm run package

# The packages alone, so that --build-context may stand in for them.
FROM scratch AS packages
COPY --from=build /src/out/package/ /

# npm and its cache stay behind here.
FROM node:${NODE}-bookworm-slim AS app
# npm packages of features that telar does not bring along: --build-arg NPM_PACKAGES="bullmq ioredis" for queues on Redis (js/docs/queue.md)
ARG NPM_PACKAGES=""
WORKDIR /opt/telar
COPY --from=packages /*.tgz /tmp/packages/
RUN npm install --omit=dev --ignore-scripts --no-audit --no-fund \
  /tmp/packages/telar-[0-9]*.tgz /tmp/packages/telar-linux-$(node -p process.arch)-[0-9]*.tgz ${NPM_PACKAGES}

FROM node:${NODE}-bookworm-slim
# Features that telar itself does not bring along, by the names of js/docs/install.md:
#   --build-arg EXTRA_PACKAGES="libopenimageio2.4 liblcms2-2 libtiff6 libembree3-3"
ARG EXTRA_PACKAGES=""
RUN apt-get update \
 && apt-get install -y --no-install-recommends libegl1 libgles2 libgl1-mesa-dri fonts-dejavu-core ${EXTRA_PACKAGES} \
 && rm -rf /var/lib/apt/lists/* /var/cache/apt/* /var/log/apt /var/log/dpkg.log
COPY --from=app /opt/telar /opt/telar
# Caches go where a container with a read-only root may write: a tmpfs on /tmp.
ENV NODE_ENV=production \
    PATH=/opt/telar/node_modules/.bin:$PATH \
    XDG_CACHE_HOME=/tmp/cache \
    HOME=/tmp
# By number, as Kubernetes' runAsNonRoot wants it: the user `node` of the base image.
USER 1000:1000
WORKDIR /tmp
EXPOSE 8080
HEALTHCHECK --interval=10s --timeout=5s --start-period=20s \
  CMD ["node", "-e", "fetch('http://127.0.0.1:8080/readyz').then((answer) => process.exit(answer.ok ? 0 : 1), () => process.exit(1))"]
ENTRYPOINT ["telar"]
CMD ["serve", "--host", "0.0.0.0"]
