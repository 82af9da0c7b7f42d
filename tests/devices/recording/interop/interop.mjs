// node interop.mjs read stream|index FILE: every message as "topic sequence log publish crc size".
// node interop.mjs write chunks|packed|plain FILE N: a file of N messages by the rule of mcap_interop_test.cpp.
import { open } from "node:fs/promises";
import { crc32 } from "@foxglove/crc";
import zstd from "@foxglove/wasm-zstd";
import { McapIndexedReader, McapStreamReader, McapWriter } from "@mcap/core";

await zstd.isLoaded;
const decompressHandlers = { zstd: (packed, size) => zstd.decompress(packed, Number(size)) };

const [, , task, kind, path, count] = process.argv;

function show(topics, message) {
  const { channelId, sequence, logTime, publishTime, data } = message;
  console.log(`${topics.get(channelId)} ${sequence} ${logTime} ${publishTime} ${crc32(data)} ${data.length}`);
}

async function readStream(file) {
  const reader = new McapStreamReader({ validateCrcs: true, decompressHandlers });
  reader.append(new Uint8Array(await file.readFile()));
  const topics = new Map();
  for (let record; (record = reader.nextRecord()); ) {
    if (record.type === "Channel") topics.set(record.id, record.topic);
    if (record.type === "Message") show(topics, record);
  }
  if (!reader.done()) throw new Error("the file does not end");
}

async function readIndex(file) {
  const readable = {
    size: async () => BigInt((await file.stat()).size),
    read: async (offset, size) => {
      const bytes = new Uint8Array(Number(size));
      await file.read(bytes, 0, Number(size), Number(offset));
      return bytes;
    },
  };
  const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers });
  const topics = new Map([...reader.channelsById].map(([id, channel]) => [id, channel.topic]));
  let messages = 0n;
  for await (const message of reader.readMessages({ validateCrcs: true })) {
    show(topics, message);
    ++messages;
  }
  for await (const attachment of reader.readAttachments({ validateCrcs: true })) {
    console.log(`attachment ${attachment.name} ${attachment.data.length}`);
  }
  for await (const metadata of reader.readMetadata()) {
    console.log(`metadata ${metadata.name} ${metadata.metadata.size}`);
  }
  if (reader.statistics.messageCount !== messages) throw new Error("the statistics are wrong");
}

async function write(file) {
  let position = 0n;
  const writable = {
    write: async (bytes) => {
      await file.write(bytes);
      position += BigInt(bytes.length);
    },
    position: () => position,
  };
  const compressChunk =
    kind === "packed" ? (data) => ({ compression: "zstd", compressedData: zstd.compress(data, 3) }) : undefined;
  const writer = new McapWriter({ writable, useChunks: kind !== "plain", chunkSize: 4096, compressChunk });
  await writer.start({ profile: "", library: "interop.mjs" });
  const schemaId = await writer.registerSchema({
    name: "S",
    encoding: "jsonschema",
    data: new TextEncoder().encode("{}"),
  });
  const channel = (topic) =>
    writer.registerChannel({ topic, schemaId, messageEncoding: "json", metadata: new Map([["k", "v"]]) });
  const ids = [await channel("/even"), await channel("/odd")];
  for (let i = 0; i < Number(count); ++i) {
    await writer.addMessage({
      channelId: ids[i % 2],
      sequence: i,
      logTime: 1000000n * BigInt(i) + 5n,
      publishTime: 1000000n * BigInt(i),
      data: new TextEncoder().encode(`{"i":${i}}` + " ".repeat(i % 7)),
    });
  }
  await writer.addAttachment({
    name: "a",
    logTime: 1n,
    createTime: 2n,
    mediaType: "text/plain",
    data: new TextEncoder().encode("hello"),
  });
  await writer.addMetadata({ name: "m", metadata: new Map([["x", "y"]]) });
  await writer.end();
}

const file = await open(path, task === "write" ? "w" : "r");
if (task === "write") await write(file);
else if (kind === "stream") await readStream(file);
else await readIndex(file);
await file.close();
